#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <exception>
#include <sstream>
#include <utility>

#include "reference/mesh_formats_impl.h"

namespace touchstone::reference {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

template <class Read>
std::vector<Vec3> vertices(std::string text, const char* format, const Read& read) {
  std::istringstream stream(std::move(text));
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  if (!read(stream, points, faces)) throw MeshError(std::string("not a whole ") + format + " mesh");
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Point& p : points) result.emplace_back(p.x(), p.y(), p.z());
  return result;
}

}  // namespace

std::vector<Vec3> obj_vertices(std::string text) {
  return vertices(std::move(text), "OBJ",
                  [](auto& in, auto& points, auto& faces) { return CGAL::IO::read_OBJ(in, points, faces); });
}

std::vector<Vec3> stl_vertices(std::string text) {
  return vertices(std::move(text), "STL",
                  [](auto& in, auto& points, auto& faces) { return CGAL::IO::read_STL(in, points, faces); });
}

}  // namespace touchstone::reference
