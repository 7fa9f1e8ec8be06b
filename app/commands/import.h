// Converts a mesh file to a scene of one convex body.
#pragma once

#include <string>

namespace touchstone::app {

/// Writes the scene to `out`, or to stdout if `out` is empty. Throws InputError.
void import_mesh(const std::string& mesh_path, const std::string& out);

}  // namespace touchstone::app
