// A scene as the command line gives it: a file, - for stdin, or the name of a scene in motion.
#pragma once

#include <string>

#include "model/input_error.h"
#include "model/scene.h"
#include "model/source_text.h"

namespace touchstone::app {

struct GivenScene {
  Scene scene;
  SourceText source;  ///< empty text: the scene has a name only

  /// An error about a JSON path of the scene, with file, line and column.
  InputError located(const InputError& error) const { return touchstone::located(error, source.text, source.name); }
};

/// A scene that is completed (reference/validity.h): that of a file, of standard input ("-"), or of a name. Throws
/// InputError: there is none, or what is wrong in the file.
GivenScene given_scene(const std::string& name_or_file);

}  // namespace touchstone::app
