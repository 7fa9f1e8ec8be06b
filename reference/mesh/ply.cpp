// PLY: a header in text that declares elements, each with properties of a scalar type or lists of them; then the
// elements' values, in text or binary. Only the element "vertex" with its x, y, z is kept; what stands before it is
// passed over.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>

#include "reference/mesh/formats.h"
#include "reference/mesh/words.h"

namespace touchstone::reference {
namespace {

enum class Encoding { text, little_endian, big_endian };

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

Scalar scalar_named(const MeshWords& words, std::string_view name) {
  using enum Scalar;
  static const std::vector<std::pair<std::array<const char*, 2>, Scalar>> names = {
      {{"char", "int8"}, int8},        {{"uchar", "uint8"}, uint8},     {{"short", "int16"}, int16},
      {{"ushort", "uint16"}, uint16},  {{"int", "int32"}, int32},       {{"uint", "uint32"}, uint32},
      {{"float", "float32"}, float32}, {{"double", "float64"}, float64}};
  for (const auto& [known, scalar] : names) {
    if (name == known[0] || name == known[1]) return scalar;
  }
  words.refuse("not a PLY mesh: unknown type \"" + std::string(name.substr(0, 40)) + "\"");
}

struct Property {
  std::string name;
  Scalar scalar = Scalar::float32;
  bool is_list = false;
  Scalar count = Scalar::uint8;  ///< of a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
};

Encoding encoding_named(const MeshWords& words, std::string_view name) {
  if (name == "ascii") return Encoding::text;
  if (name == "binary_little_endian") return Encoding::little_endian;
  if (name == "binary_big_endian") return Encoding::big_endian;
  words.refuse("not a PLY mesh: unknown format \"" + std::string(name.substr(0, 40)) + "\"");
}

Property property_from(MeshWords& words) {
  Property property;
  std::string_view type = words.word_of_line();
  if (type == "list") {
    property.is_list = true;
    property.count = scalar_named(words, words.word_of_line());
    type = words.word_of_line();
  }
  property.scalar = scalar_named(words, type);
  property.name = words.word_of_line();
  return property;
}

/// Up to the first byte of the elements.
Header header_from(MeshWords& words) {
  Header header;
  if (words.word_of_line() != "ply") words.refuse("not a PLY mesh: its first line is not \"ply\"");
  for (words.skip_line(); !words.is_at_end(); words.skip_line()) {
    const std::string_view keyword = words.word_of_line();
    if (keyword == "end_header") {
      words.skip_line();
      return header;
    }
    if (keyword == "format") header.encoding = encoding_named(words, words.word_of_line());
    if (keyword == "element") {
      const std::string name(words.word_of_line());
      header.elements.push_back({name, words.count(words.word_of_line()), {}});
    }
    if (keyword == "property") {
      if (header.elements.empty()) words.refuse("not a PLY mesh: a property before any element");
      header.elements.back().properties.push_back(property_from(words));
    }
  }
  words.refuse("not a whole PLY mesh: no end_header");
}

constexpr const char* cut_short = "not a whole PLY mesh: it ends before its last vertex";

template <class Number>
double from_binary(MeshWords& words, Encoding encoding) {
  std::array<char, sizeof(Number)> bytes{};
  if (!words.copy_bytes(bytes.data(), bytes.size())) throw MeshError(cut_short);
  const bool is_big = encoding == Encoding::big_endian;
  if (is_big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return static_cast<double>(std::bit_cast<Number>(bytes));
}

double next_value(MeshWords& words, Encoding encoding, Scalar scalar) {
  if (encoding == Encoding::text) {
    const std::string_view word = words.word();
    if (word.empty()) words.refuse(cut_short);
    return words.number(word);
  }
  switch (scalar) {
    case Scalar::int8:
      return from_binary<std::int8_t>(words, encoding);
    case Scalar::uint8:
      return from_binary<std::uint8_t>(words, encoding);
    case Scalar::int16:
      return from_binary<std::int16_t>(words, encoding);
    case Scalar::uint16:
      return from_binary<std::uint16_t>(words, encoding);
    case Scalar::int32:
      return from_binary<std::int32_t>(words, encoding);
    case Scalar::uint32:
      return from_binary<std::uint32_t>(words, encoding);
    case Scalar::float32:
      return from_binary<float>(words, encoding);
    case Scalar::float64:
      break;
  }
  return from_binary<double>(words, encoding);
}

/// One item of an element; a property that is not a coordinate is passed over.
Vec3 next_item(MeshWords& words, Encoding encoding, const Element& element) {
  Vec3 p = Vec3::Zero();
  for (const Property& property : element.properties) {
    if (property.is_list) {
      for (double left = next_value(words, encoding, property.count); left > 0; --left)
        next_value(words, encoding, property.scalar);
      continue;
    }
    const double value = next_value(words, encoding, property.scalar);
    if (property.name == "x") p.x() = value;
    if (property.name == "y") p.y() = value;
    if (property.name == "z") p.z() = value;
  }
  return p;
}

void require_coordinates(const Element& vertex) {
  for (const char* name : {"x", "y", "z"}) {
    const auto is_coordinate = [&](const Property& property) { return property.name == name && !property.is_list; };
    if (std::count_if(vertex.properties.begin(), vertex.properties.end(), is_coordinate) != 1) {
      throw MeshError(std::string("not a PLY mesh: a vertex needs one number ") + name);
    }
  }
}

}  // namespace

std::vector<Vec3> ply_vertices(std::string_view text) {
  MeshWords words(text);
  const Header header = header_from(words);
  if (header.encoding == Encoding::text) words.expect_text();
  for (const Element& element : header.elements) {
    const bool is_vertex = element.name == "vertex";
    if (is_vertex) require_coordinates(element);
    if (element.properties.empty()) continue;  // it has no values, however many of it there are
    std::vector<Vec3> vertices;
    for (std::size_t i = 0; i < element.count; ++i) {
      const Vec3 item = next_item(words, header.encoding, element);
      if (is_vertex) vertices.push_back(item);
    }
    if (is_vertex) return vertices;
  }
  throw MeshError("not a PLY mesh: no element \"vertex\"");
}

}  // namespace touchstone::reference
