// Triangle meshes from files, as the convex solids that collision code makes of them.
#pragma once

#include <cstdint>
#include <string>

#include "model/shape.h"

namespace touchstone::reference {

/// A larger file is refused unread: no convex collision body needs it, and its hull would take minutes.
inline constexpr std::uintmax_t largest_mesh_bytes = 100'000'000;

/// The exact convex hull (reference/convex_hull.h) of all points of an OBJ, OFF, PLY or STL file (ASCII or binary),
/// read by CGAL. Throws InputError naming the file: missing, too large, of another kind, not a mesh, a point that is
/// not finite, or all points in one plane.
Polytope read_mesh(const std::string& path);

}  // namespace touchstone::reference
