// The vertices of a mesh, one function a format. Each throws MeshError saying why the text is not such a mesh.
//
// Only vertices are needed, so they are read here and not by CGAL's readers of polygon soups (5.5), which believe what
// a file declares (forty bytes of OFF or PLY can ask for all memory), crash on a PLY file whose x is an integer, and
// take a NaN in an STL file for a vertex seen before.
#pragma once

#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "model/frame.h"

namespace touchstone::reference {

struct MeshError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::vector<Vec3> obj_vertices(std::string text);
std::vector<Vec3> off_vertices(std::string text);
std::vector<Vec3> ply_vertices(std::string text);
std::vector<Vec3> stl_vertices(std::string text);

/// The whole word as a number, to the nearest double where the number is one.
template <class Number>
Number number_from(std::string_view word) {
  Number number{};
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size()) {
    throw MeshError("expected a number, found \"" + std::string(word.substr(0, 40)) + "\"");
  }
  return number;
}

}  // namespace touchstone::reference
