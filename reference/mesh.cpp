#include "reference/mesh.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "model/input_error.h"
#include "model/json.h"
#include "reference/convex_hull.h"
#include "reference/mesh_formats_impl.h"

namespace touchstone::reference {
namespace {

using Reader = std::vector<Vec3> (*)(std::string text);

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

void require_size(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path, "no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw InputError(path, "not a plain file");
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) throw InputError(path, "cannot read: " + error.message());
  if (bytes > largest_mesh_bytes) {
    throw InputError(path, "has " + std::to_string(bytes / 1'000'000) + " MB; a mesh may have " +
                               std::to_string(largest_mesh_bytes / 1'000'000));
  }
}

void require_finite(const std::vector<Vec3>& vertices, const std::string& path) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!vertices[i].allFinite()) {
      throw InputError(path, "vertex " + std::to_string(i) + " is NaN or infinite; expected finite coordinates");
    }
  }
}

}  // namespace

Polytope read_mesh(const std::string& path) {
  const Reader vertices_of = reader_for(path);
  require_size(path);
  try {
    const std::vector<Vec3> vertices = vertices_of(read_text(path));
    require_finite(vertices, path);
    return convex_hull(vertices);
  } catch (const MeshError& error) {
    throw InputError(path, error.what());
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw what.starts_with(path) ? error : InputError(path, what);
  }
}

}  // namespace touchstone::reference
