// OBJ: lines whose first word is "v" hold x y z, perhaps followed by a weight or a colour; the other lines are not
// needed, except that a mesh without a face is none.
#include "reference/mesh/formats.h"
#include "reference/mesh/words.h"

namespace touchstone::reference {

std::vector<Vec3> obj_vertices(std::string_view text) {
  MeshWords words(text);
  words.expect_text();
  std::vector<Vec3> vertices;
  bool has_face = false;
  for (; !words.is_at_end(); words.skip_line()) {
    const std::string_view keyword = words.word_of_line();
    if (keyword == "f") has_face = true;
    if (keyword == "v") vertices.push_back(words.point_of_line());
  }
  if (!has_face) throw MeshError("not an OBJ mesh: no line \"f\"");
  return vertices;
}

}  // namespace touchstone::reference
