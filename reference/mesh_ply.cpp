// PLY: a header in text that declares elements, each with properties of a scalar type or lists of them; then the
// elements' values, in text or binary. Only the element "vertex" with its x, y, z is kept; what stands before it is
// passed over.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <sstream>
#include <utility>

#include "reference/mesh_formats_impl.h"

namespace touchstone::reference {
namespace {

enum class Encoding { text, little_endian, big_endian };

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

Scalar scalar_named(const std::string& name) {
  using enum Scalar;
  static const std::vector<std::pair<std::array<const char*, 2>, Scalar>> names = {
      {{"char", "int8"}, int8},        {{"uchar", "uint8"}, uint8},     {{"short", "int16"}, int16},
      {{"ushort", "uint16"}, uint16},  {{"int", "int32"}, int32},       {{"uint", "uint32"}, uint32},
      {{"float", "float32"}, float32}, {{"double", "float64"}, float64}};
  for (const auto& [known, scalar] : names) {
    if (name == known[0] || name == known[1]) return scalar;
  }
  throw MeshError("not a PLY mesh: unknown type \"" + name.substr(0, 40) + "\"");
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

Encoding encoding_named(const std::string& name) {
  if (name == "ascii") return Encoding::text;
  if (name == "binary_little_endian") return Encoding::little_endian;
  if (name == "binary_big_endian") return Encoding::big_endian;
  throw MeshError("not a PLY mesh: unknown format \"" + name.substr(0, 40) + "\"");
}

Property property_from(std::istringstream& line) {
  Property property;
  std::string type;
  line >> type;
  if (type == "list") {
    property.is_list = true;
    line >> type;
    property.count = scalar_named(type);
    line >> type;
  }
  property.scalar = scalar_named(type);
  line >> property.name;
  return property;
}

Header header_from(std::istringstream& in) {
  Header header;
  std::string text;
  std::getline(in, text);
  if (text != "ply" && text != "ply\r") throw MeshError("not a PLY mesh: its first line is not \"ply\"");
  while (std::getline(in, text)) {
    std::istringstream line(text);
    std::string keyword;
    std::string word;
    line >> keyword;
    if (keyword == "end_header") return header;
    if (keyword == "format" && line >> word) header.encoding = encoding_named(word);
    if (keyword == "element" && line >> word) {
      std::string count;
      line >> count;
      header.elements.push_back({word, number_from<std::size_t>(count), {}});
    }
    if (keyword == "property") {
      if (header.elements.empty()) throw MeshError("not a PLY mesh: a property before any element");
      header.elements.back().properties.push_back(property_from(line));
    }
  }
  throw MeshError("not a whole PLY mesh: no end_header");
}

template <class Number>
double from_binary(std::istringstream& in, Encoding encoding) {
  std::array<char, sizeof(Number)> bytes{};
  if (!in.read(bytes.data(), bytes.size())) throw MeshError("not a whole PLY mesh: it ends before its last vertex");
  const bool is_big = encoding == Encoding::big_endian;
  if (is_big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return static_cast<double>(std::bit_cast<Number>(bytes));
}

double next_value(std::istringstream& in, Encoding encoding, Scalar scalar) {
  if (encoding == Encoding::text) {
    std::string word;
    if (!(in >> word)) throw MeshError("not a whole PLY mesh: it ends before its last vertex");
    return number_from<double>(word);
  }
  switch (scalar) {
    case Scalar::int8:
      return from_binary<std::int8_t>(in, encoding);
    case Scalar::uint8:
      return from_binary<std::uint8_t>(in, encoding);
    case Scalar::int16:
      return from_binary<std::int16_t>(in, encoding);
    case Scalar::uint16:
      return from_binary<std::uint16_t>(in, encoding);
    case Scalar::int32:
      return from_binary<std::int32_t>(in, encoding);
    case Scalar::uint32:
      return from_binary<std::uint32_t>(in, encoding);
    case Scalar::float32:
      return from_binary<float>(in, encoding);
    case Scalar::float64:
      break;
  }
  return from_binary<double>(in, encoding);
}

/// One item of an element; a property that is not a coordinate is passed over.
Vec3 next_item(std::istringstream& in, Encoding encoding, const Element& element) {
  Vec3 p = Vec3::Zero();
  for (const Property& property : element.properties) {
    if (property.is_list) {
      for (double left = next_value(in, encoding, property.count); left > 0; --left)
        next_value(in, encoding, property.scalar);
      continue;
    }
    const double value = next_value(in, encoding, property.scalar);
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

std::vector<Vec3> ply_vertices(std::string text) {
  std::istringstream in(std::move(text));
  const Header header = header_from(in);
  for (const Element& element : header.elements) {
    const bool is_vertex = element.name == "vertex";
    if (is_vertex) require_coordinates(element);
    if (element.properties.empty()) continue;  // it has no values, however many of it there are
    std::vector<Vec3> vertices;
    for (std::size_t i = 0; i < element.count; ++i) {
      const Vec3 item = next_item(in, header.encoding, element);
      if (is_vertex) vertices.push_back(item);
    }
    if (is_vertex) return vertices;
  }
  throw MeshError("not a PLY mesh: no element \"vertex\"");
}

}  // namespace touchstone::reference
