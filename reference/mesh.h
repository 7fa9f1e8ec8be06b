// Meshes of other programs as convex polytopes.
#pragma once

#include <string>
#include <vector>

#include "model/shape.h"

namespace touchstone::reference {

/// The convex hull of a mesh's vertices, whether or not its faces use them; a face's indices are not looked at. The
/// file's name tells the format: .obj, .off, .stl (text or binary), .ply (text or binary); of "-", standard input, the
/// first word does. Coordinates are read as the nearest doubles. Throws InputError naming the file and, in text, the
/// line and the column: what read_source refuses (model/source_text.h), another format, not such a mesh, a coordinate
/// that a double does not hold, fewer than 4 vertices or all in one plane.
Polytope read_mesh(const std::string& path);

/// The vertices of a mesh in text, which is of the format that `path` tells. Throws as read_mesh does, but for hulls.
std::vector<Vec3> mesh_vertices(std::string text, const std::string& path);

}  // namespace touchstone::reference
