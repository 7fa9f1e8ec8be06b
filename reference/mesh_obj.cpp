// OBJ: lines whose first word is "v" hold x y z, perhaps followed by a weight or a colour; the other lines are not
// needed, except that a mesh without a face is none.
#include <sstream>
#include <utility>

#include "reference/mesh_formats_impl.h"

namespace touchstone::reference {

std::vector<Vec3> obj_vertices(std::string text) {
  std::istringstream in(std::move(text));
  std::vector<Vec3> vertices;
  bool has_face = false;
  for (std::string row; std::getline(in, row);) {
    std::istringstream line(row);
    std::string keyword;
    line >> keyword;
    if (keyword == "f") has_face = true;
    if (keyword != "v") continue;
    std::string x;
    std::string y;
    std::string z;
    line >> x >> y >> z;
    vertices.emplace_back(number_from<double>(x), number_from<double>(y), number_from<double>(z));
  }
  if (!has_face) throw MeshError("not an OBJ mesh: no line \"f\"");
  return vertices;
}

}  // namespace touchstone::reference
