// Meshes of other programs as convex polytopes.
#pragma once

#include <cstdint>
#include <string>

#include "model/shape.h"

namespace touchstone::reference {

/// A larger file is refused unread: 2 million triangles of binary STL.
inline constexpr std::uintmax_t largest_mesh_bytes = 100'000'000;

/// The convex hull of a mesh's vertices, whether or not its faces use them; a face's indices are not looked at. The
/// file's name tells the format: .obj, .off, .stl (text or binary), .ply (text or binary). Coordinates are read as the
/// nearest doubles. Throws InputError naming the file: missing, not a plain file, above largest_mesh_bytes, of another
/// format, not such a mesh, a coordinate that is not finite, fewer than 4 vertices or all in one plane.
Polytope read_mesh(const std::string& path);

}  // namespace touchstone::reference
