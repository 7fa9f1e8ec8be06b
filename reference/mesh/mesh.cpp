#include "reference/mesh.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "model/input_error.h"
#include "model/source_text.h"
#include "reference/convex_hull.h"
#include "reference/mesh/formats.h"
#include "reference/mesh/words.h"

namespace touchstone::reference {
namespace {

using Reader = std::vector<Vec3> (*)(std::string_view text);

constexpr std::array<std::pair<const char*, Reader>, 4> readers = {
    {{".obj", obj_vertices}, {".off", off_vertices}, {".stl", stl_vertices}, {".ply", ply_vertices}}};

Reader reader_for(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [known, reader] : readers) {
    if (extension == known) return reader;
  }
  const std::string found = extension == ".dae" ? "COLLADA (.dae) is not read" : "not a mesh format by its name";
  throw InputError(path, found + "; expected .obj, .off, .stl or .ply");
}

/// Standard input has no name; the first word tells.
Reader reader_of(std::string_view text) {
  const std::string_view first = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (first.starts_with("ply")) return ply_vertices;
  if (first.starts_with("solid") || is_binary_stl(text)) return stl_vertices;
  const std::string_view word = first.substr(0, first.find_first_of(" \t\r\n"));
  return word.ends_with("OFF") ? off_vertices : obj_vertices;
}

/// Binary formats can hold any.
void require_finite(const std::vector<Vec3>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!vertices[i].allFinite()) {
      throw InputError("vertex " + std::to_string(i), "NaN or infinite; expected finite coordinates");
    }
  }
}

struct Named {
  std::string name;         ///< for messages
  Reader reader = nullptr;  ///< none: the text tells
};

Named named(const std::string& path) { return path == "-" ? Named{"<stdin>"} : Named{path, reader_for(path)}; }

/// What `made_of` makes of the vertices; errors name the mesh.
template <class MadeOf>
auto from_vertices(std::string text, const Named& mesh, const MadeOf& made_of) {
  try {
    if (!is_binary_stl(text)) text = without_byte_order_mark(std::move(text));
    const Reader vertices_of = mesh.reader ? mesh.reader : reader_of(text);
    const std::vector<Vec3> vertices = vertices_of(text);
    require_finite(vertices);
    return made_of(vertices);
  } catch (const MeshError& error) {
    throw InputError(error.offset ? mesh.name + ':' + line_and_column(text, *error.offset) : mesh.name, error.what());
  } catch (const InputError& error) {
    throw InputError(mesh.name, error.what());
  }
}

}  // namespace

std::vector<Vec3> mesh_vertices(std::string text, const std::string& path) {
  return from_vertices(std::move(text), named(path), [](const std::vector<Vec3>& vertices) { return vertices; });
}

Polytope read_mesh(const std::string& path) {
  const Named mesh = named(path);
  return from_vertices(read_text(path), mesh, convex_hull);
}

}  // namespace touchstone::reference
