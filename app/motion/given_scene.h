// A scene as the command line names it: a file, - for stdin, or the name of a scene in motion.
#pragma once

#include <string>

#include "model/input_error.h"
#include "model/scene.h"
#include "model/source_text.h"

namespace touchstone::app {

struct GivenScene {
  Scene scene;
  SourceText source;  ///< empty text: the scene has only a name

  /// Adds file, line and column to an error about a JSON path of the scene.
  InputError located(const InputError& error) const { return touchstone::located(error, source.text, source.name); }
};

/// Returns a completed scene (reference/validity.h) from a file, from standard input ("-"), or by its name. Throws
/// InputError if there is none, or says what is wrong in the file.
GivenScene given_scene(const std::string& name_or_file);

}  // namespace touchstone::app
