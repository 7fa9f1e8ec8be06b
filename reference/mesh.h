// Meshes of other programs as convex polytopes.
#pragma once

#include <cstdint>
#include <string>

#include "model/shape.h"

namespace touchstone::reference {

/// A larger file is refused before it is read: 1.3 million triangles of binary STL, about 1 GB while its hull is taken.
constexpr std::uintmax_t mesh_bytes_at_most = 64'000'000;

/// The convex hull of a mesh's vertices, whether or not its faces use them; a face's indices are not looked at. The
/// file's name tells the format: .obj, .off, .stl (text or binary), .ply (text or binary). Coordinates are read as the
/// nearest doubles. Throws InputError naming the file: missing, not a plain file, above mesh_bytes_at_most, of another
/// format, not such a mesh, a coordinate that is not finite, fewer than 4 vertices or all in one plane.
Polytope read_mesh(const std::string& path);

}  // namespace touchstone::reference
