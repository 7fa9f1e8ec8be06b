// A scene as the command line gives it: a file, - for stdin, or the name of a scene in motion.
#pragma once

#include <string>

#include "model/scene.h"

namespace touchstone::app {

/// Completed (reference/validity.h). Throws InputError: there is neither, or what is wrong in the file.
Scene given_scene(const std::string& name_or_file);

}  // namespace touchstone::app
