// STL in binary: 80 bytes of anything, the number n of triangles, then n times a normal, three vertices (floats) and
// two bytes; its size tells it from text, which may start with the same word. In text, "vertex x y z" three times a
// facet.
#include <bit>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <utility>

#include "reference/mesh_formats_impl.h"

namespace touchstone::reference {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian: reverse the bytes here");

template <class Number>
Number at(const std::string& bytes, std::size_t offset) {
  Number number;
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

bool is_binary(const std::string& bytes) {
  return bytes.size() >= header_bytes &&
         bytes.size() - header_bytes == std::uint64_t{triangle_bytes} * at<std::uint32_t>(bytes, 80);
}

std::vector<Vec3> from_binary(const std::string& bytes) {
  std::vector<Vec3> vertices;
  for (std::size_t triangle = header_bytes; triangle < bytes.size(); triangle += triangle_bytes) {
    for (std::size_t corner = triangle + 12; corner < triangle + 48; corner += 12) {
      vertices.emplace_back(at<float>(bytes, corner), at<float>(bytes, corner + 4), at<float>(bytes, corner + 8));
    }
  }
  return vertices;
}

double next_number(std::istringstream& in) {
  std::string word;
  in >> word;
  return number_from<double>(word);
}

std::vector<Vec3> from_text(std::string text) {
  std::istringstream in(std::move(text));
  std::vector<Vec3> vertices;
  bool is_ended = false;
  for (std::string word; in >> word;) {
    if (word == "vertex") {
      const double x = next_number(in);
      const double y = next_number(in);
      vertices.emplace_back(x, y, next_number(in));
    }
    is_ended = word == "endsolid" || (is_ended && word != "solid");
  }
  if (!is_ended) throw MeshError("not a whole STL mesh: no endsolid");
  return vertices;
}

}  // namespace

std::vector<Vec3> stl_vertices(std::string text) {
  if (is_binary(text)) return from_binary(text);
  if (text.find_first_not_of(" \t\r\n") == text.find("solid")) return from_text(std::move(text));
  throw MeshError("not an STL mesh: neither text that starts with \"solid\" nor of the size that its header declares");
}

}  // namespace touchstone::reference
