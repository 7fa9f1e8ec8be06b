// OFF: a first word that ends in OFF, the numbers of vertices, faces and edges, then a line a vertex that
// starts with x y z. What follows on the line (colours, normals) and the faces are not needed.
#include "reference/mesh/formats.h"
#include "reference/mesh/words.h"

namespace touchstone::reference {
namespace {

void expect_more(MeshWords& words) {
  if (!words.skip_to_word()) words.refuse("not a whole OFF mesh: it ends before its last vertex");
}

}  // namespace

std::vector<Vec3> off_vertices(std::string_view text) {
  MeshWords words(text, '#');
  words.expect_text();
  expect_more(words);
  const std::string_view header = words.word_of_line();
  // ST, C, N before OFF add texture, colour, normal after x y z; 4OFF, nOFF and binary have other vertices.
  if (header != "OFF" && header != "COFF" && header != "NOFF" && header != "CNOFF" && header != "STOFF") {
    words.refuse("not an OFF mesh in text with three coordinates a vertex: it starts with \"" +
                 std::string(header.substr(0, 40)) + "\"");
  }
  expect_more(words);
  std::vector<Vec3> vertices;
  for (std::size_t left = words.count(words.word_of_line()); left > 0; --left) {
    words.skip_line();
    expect_more(words);
    vertices.push_back(words.point_of_line());
  }
  return vertices;
}

}  // namespace touchstone::reference
