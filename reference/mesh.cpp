#include "reference/mesh.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <tuple>
#include <vector>

#include "model/input_error.h"
#include "reference/convex_hull.h"

namespace touchstone::reference {
namespace {

namespace fs = std::filesystem;
using SoupPoint = CGAL::Simple_cartesian<double>::Point_3;

void require_readable(const fs::path& path) {
  static const std::set<std::string> endings = {".obj", ".off", ".ply", ".stl"};
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (!fs::exists(path)) throw InputError(path.string(), "no such file");
  if (!fs::is_regular_file(path)) throw InputError(path.string(), "not a file");
  if (!endings.contains(ending)) {
    throw InputError(path.string(),
                     "not a mesh format that is read here: OBJ, OFF, PLY and STL are (by the file's ending)");
  }
  const std::uintmax_t size = fs::file_size(path);
  if (size > largest_mesh_bytes) {
    throw InputError(path.string(),
                     fmt::format("{} bytes; a mesh may have {}: simplify it first", size, largest_mesh_bytes));
  }
}

/// Each point once, in the order of the file: a soup repeats a vertex for each triangle.
std::vector<Vec3> distinct(const std::vector<SoupPoint>& soup, const std::string& path) {
  std::set<std::tuple<double, double, double>> seen;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < soup.size(); ++i) {
    const SoupPoint& p = soup[i];
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) {
      throw InputError(path, "point " + std::to_string(i) + " is not finite");
    }
    if (seen.emplace(p.x(), p.y(), p.z()).second) points.emplace_back(p.x(), p.y(), p.z());
  }
  return points;
}

}  // namespace

Polytope read_mesh(const std::string& path) {
  require_readable(path);
  std::vector<SoupPoint> soup;
  std::vector<std::vector<std::size_t>> polygons;
  bool read = false;
  try {
    read = CGAL::IO::read_polygon_soup(path, soup, polygons, CGAL::parameters::verbose(false));
  } catch (const std::exception&) {
    // A reader that trips over the text says no more than that.
  }
  if (!read || soup.empty()) throw InputError(path, "not a mesh in the format that its ending names");
  try {
    return convex_hull(distinct(soup, path));
  } catch (const InputError& error) {
    throw InputError(path, error.what());
  }
}

}  // namespace touchstone::reference
