// The vertices of a mesh, one function a format. Each throws MeshError saying why the text is not such a mesh.
//
// Only vertices are needed, so they are read here and not by CGAL's readers of polygon soups (5.5), which believe what
// a file declares (forty bytes of OFF or PLY can ask for all memory), crash on a PLY file whose x is an integer, and
// take a NaN in an STL file for a vertex seen before.
#pragma once

#include <string_view>
#include <vector>

#include "model/frame.h"

namespace touchstone::reference {

std::vector<Vec3> obj_vertices(std::string_view text);
std::vector<Vec3> off_vertices(std::string_view text);
std::vector<Vec3> ply_vertices(std::string_view text);
std::vector<Vec3> stl_vertices(std::string_view text);

/// As its size tells; text may begin with the same word.
bool is_binary_stl(std::string_view bytes);

}  // namespace touchstone::reference
