// What the optimised broad phase does for a scene, and what it leaves out.
#pragma once

#include <string>

namespace touchstone::app {

/// Reads the scene (app/motion/given_scene.h) and prints the plan to stdout, as words or as JSON. Throws InputError.
void plan(const std::string& name_or_file, bool as_json);

}  // namespace touchstone::app
