// STL in binary: 80 bytes of anything, the number n of triangles, then n times a normal, three vertices (floats) and
// two bytes; its size tells it from text, which may start with the same word. In text, "vertex x y z" three times a
// facet.
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "reference/mesh/formats.h"
#include "reference/mesh/words.h"

namespace touchstone::reference {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian: reverse the bytes here");

template <class Number>
Number at(std::string_view bytes, std::size_t offset) {
  Number number;
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

std::vector<Vec3> from_binary(std::string_view bytes) {
  std::vector<Vec3> vertices;
  for (std::size_t triangle = header_bytes; triangle < bytes.size(); triangle += triangle_bytes) {
    for (std::size_t corner = triangle + 12; corner < triangle + 48; corner += 12) {
      vertices.emplace_back(at<float>(bytes, corner), at<float>(bytes, corner + 4), at<float>(bytes, corner + 8));
    }
  }
  return vertices;
}

/// The rest of the line that begins or ends a solid: any words, up to a facet of a file without lines.
void skip_name(MeshWords& words) {
  std::string_view word = words.word_of_line();
  while (!word.empty() && word != "facet") word = words.word_of_line();
}

std::vector<Vec3> from_text(std::string_view text) {
  MeshWords words(text);
  words.expect_text();
  std::vector<Vec3> vertices;
  bool is_ended = false;
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    if (word == "vertex") {
      const double x = words.number(words.word());
      const double y = words.number(words.word());
      vertices.emplace_back(x, y, words.number(words.word()));
    }
    is_ended = word == "endsolid" || (is_ended && word != "solid");
    if (word == "solid" || word == "endsolid") skip_name(words);
  }
  if (!is_ended) words.refuse("not a whole STL mesh: no endsolid");
  return vertices;
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= header_bytes &&
         bytes.size() - header_bytes == std::uint64_t{triangle_bytes} * at<std::uint32_t>(bytes, 80);
}

std::vector<Vec3> stl_vertices(std::string_view text) {
  if (is_binary_stl(text)) return from_binary(text);
  if (text.find_first_not_of(" \t\r\n") == text.find("solid")) return from_text(text);
  throw MeshError("not an STL mesh: neither text that starts with \"solid\" nor of the size that its header declares");
}

}  // namespace touchstone::reference
