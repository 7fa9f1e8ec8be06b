// OFF: a first word that ends in OFF, the numbers of vertices, faces and edges, then a line a vertex that
// starts with x y z. What follows on the line (colours, normals) and the faces are not needed.
#include <algorithm>
#include <sstream>
#include <utility>

#include "reference/mesh_formats_impl.h"

namespace touchstone::reference {
namespace {

/// The next line with something on it before any '#'.
std::istringstream next_line(std::istringstream& text) {
  std::string line;
  while (std::getline(text, line)) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") != std::string::npos) return std::istringstream(line);
  }
  throw MeshError("not a whole OFF mesh: it ends before its last vertex");
}

template <class Number>
Number next_number(std::istringstream& line) {
  std::string word;
  line >> word;
  return number_from<Number>(word);
}

}  // namespace

std::vector<Vec3> off_vertices(std::string text) {
  std::istringstream in(std::move(text));
  std::istringstream line = next_line(in);
  std::string header;
  line >> header;
  // ST, C, N before OFF add texture, colour, normal after x y z; 4OFF, nOFF and binary have other vertices.
  if (header != "OFF" && header != "COFF" && header != "NOFF" && header != "CNOFF" && header != "STOFF") {
    throw MeshError("not an OFF mesh in text with three coordinates a vertex: it starts with \"" +
                    header.substr(0, 40) + "\"");
  }
  if ((line >> std::ws).eof()) line = next_line(in);
  std::vector<Vec3> vertices;
  for (std::size_t left = next_number<std::size_t>(line); left > 0; --left) {
    line = next_line(in);
    const double x = next_number<double>(line);
    const double y = next_number<double>(line);
    vertices.emplace_back(x, y, next_number<double>(line));
  }
  return vertices;
}

}  // namespace touchstone::reference
