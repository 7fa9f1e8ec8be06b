#include "reference/convex_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "model/input_error.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::Dice;
using Integers = Eigen::Matrix<long long, 3, 1>;

Integers integers(const Vec3& v) { return v.cast<long long>(); }

long long det(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (integers(b) - integers(a)).dot((integers(c) - integers(a)).cross(integers(d) - integers(a)));
}

/// A closed surface of strictly convex plane polygons that has every point on or below each of its planes is the hull;
/// no two neighbours share a plane. All in integers, so it owes nothing to the predicates of the library.
void require_hull_of(const std::vector<Vec3>& points, const Polytope& hull) {
  const auto at = [&](int i) -> const Vec3& { return hull.vertices[static_cast<std::size_t>(i)]; };
  std::map<std::pair<int, int>, std::size_t> left;
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    const std::vector<int>& face = hull.faces[f];
    REQUIRE(face.size() >= 3);
    REQUIRE(*std::min_element(face.begin(), face.end()) == face.front());
    const Vec3& a = at(face[0]);
    const Vec3& b = at(face[1]);
    const Vec3& c = at(face[2]);
    const Integers n = (integers(b) - integers(a)).cross(integers(c) - integers(a));
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec3& p = at(face[k]);
      const Vec3& q = at(face[(k + 1) % face.size()]);
      const Vec3& r = at(face[(k + 2) % face.size()]);
      REQUIRE(det(a, b, c, p) == 0);
      REQUIRE(n.dot((integers(q) - integers(p)).cross(integers(r) - integers(q))) > 0);
      REQUIRE(left.emplace(std::pair(face[k], face[(k + 1) % face.size()]), f).second);
    }
    for (const Vec3& p : points) REQUIRE(n.dot(integers(p) - integers(a)) <= 0);
  }
  for (const auto& [edge, f] : left) {
    const auto other = left.find({edge.second, edge.first});
    REQUIRE(other != left.end());
    const std::vector<int>& face = hull.faces[f];
    const std::vector<int>& neighbour = hull.faces[other->second];
    REQUIRE(std::any_of(neighbour.begin(), neighbour.end(),
                        [&](int v) { return det(at(face[0]), at(face[1]), at(face[2]), at(v)) != 0; }));
  }
  REQUIRE(hull.vertices.size() + hull.faces.size() == left.size() / 2 + 2);
  REQUIRE(std::is_sorted(hull.faces.begin(), hull.faces.end()));
  auto from = points.begin();  // the order of the input
  for (const Vec3& v : hull.vertices) {
    from = std::find(from, points.end(), v);
    REQUIRE(from != points.end());
    ++from;
  }
}

/// Points of a small lattice: duplicates, collinear and coplanar ones abound. Empty when all are in one plane.
std::vector<Vec3> lattice_points(Dice& dice, int n, int reach) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) points.push_back(dice.lattice(reach));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        for (std::size_t l = 0; l < k; ++l)
          if (det(points[i], points[j], points[k], points[l]) != 0) return points;
  return {};
}

std::string message(const std::vector<Vec3>& points) {
  try {
    convex_hull(points);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("convex_hull: the hull of a lattice of points is a cube") {
  std::vector<Vec3> points;
  for (int i = 0; i < 27; ++i) points.emplace_back(i % 3, i / 3 % 3, i / 9);
  const Polytope cube = convex_hull(points);
  CHECK(cube.vertices ==
        std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}});
  CHECK(cube.faces == std::vector<std::vector<int>>{
                          {0, 1, 5, 4}, {0, 2, 3, 1}, {0, 4, 6, 2}, {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}});
}

TEST_CASE("convex_hull: hulls of lattice points keep the laws, flat ones are refused") {
  Dice dice(11);
  for (int i = 0; i < 3000; ++i) {
    const int n = dice.between(4, 14);
    const std::vector<Vec3> points = lattice_points(dice, n, dice.between(1, 3));
    if (points.empty()) continue;
    require_hull_of(points, convex_hull(points));
  }
  CHECK(message({}) == "points: fewer than 4: a solid needs 4 that are not in one plane");
  CHECK(message({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) ==
        "points: fewer than 4: a solid needs 4 that are not in one plane");
  const std::string flat = "points: all in one plane: a solid needs 4 that are not";
  CHECK(message(std::vector<Vec3>(9, Vec3(1, 2, 3))) == flat);
  CHECK(message({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {-1, -1, -1}}) == flat);
  CHECK(message({{0, 0, 1}, {5, 0, 1}, {0, 7, 1}, {5, 7, 1}, {2, 2, 1}}) == flat);
}

TEST_CASE("convex_hull: a larger hull keeps the laws") {
  const Polytope sphere = tests::lattice_sphere(1105);
  CHECK(sphere.vertices.size() > 150);
  require_hull_of(sphere.vertices, sphere);
}

TEST_CASE("convex_hull: a power of two changes no face, nor does an exact translation") {
  Dice dice(12);
  for (int i = 0; i < 300; ++i) {
    const std::vector<Vec3> points = lattice_points(dice, 9, 2);
    if (points.empty()) continue;
    const Polytope hull = convex_hull(points);
    for (const double s : {0x1p500, 0x1p-500, 0x1p-1070, 0x1p1020, -1.0}) {
      std::vector<Vec3> scaled = points;
      for (Vec3& p : scaled) p *= s;
      const Polytope other = convex_hull(scaled);
      REQUIRE(other.vertices.size() == hull.vertices.size());
      if (s > 0) REQUIRE(other.faces == hull.faces);
    }
    std::vector<Vec3> far = points;
    for (Vec3& p : far) p += Vec3(0x1p50, -0x1p49, 0x1p50);
    REQUIRE(convex_hull(far).faces == hull.faces);
  }
}

TEST_CASE("convex_hull: the order of the points changes no vertex and no number of faces") {
  Dice dice(13);
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  for (int i = 0; i < 300; ++i) {
    std::vector<Vec3> points = lattice_points(dice, 10, 2);
    if (points.empty()) continue;
    Polytope a = convex_hull(points);
    REQUIRE(convex_hull(points) == a);
    for (std::size_t k = points.size() - 1; k > 0; --k)
      std::swap(points[k], points[static_cast<std::size_t>(dice.between(0, static_cast<int>(k)))]);
    Polytope b = convex_hull(points);
    std::sort(a.vertices.begin(), a.vertices.end(), before);
    std::sort(b.vertices.begin(), b.vertices.end(), before);
    REQUIRE(a.vertices == b.vertices);
    REQUIRE(a.faces.size() == b.faces.size());
  }
}

TEST_CASE("convex_hull: an ulp off a plane is off the plane") {
  std::vector<Vec3> cube;
  for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  CHECK(convex_hull(cube).faces.size() == 6);
  cube[7].x() = std::nextafter(1.0, 2.0);  // three faces meet there; the two that contain the x axis stay plane
  CHECK(convex_hull(cube).faces.size() == 7);
  cube[7].x() = std::nextafter(1.0, 0.0);
  CHECK(convex_hull(cube).faces.size() == 7);
  cube.emplace_back(0.5, 0.5, std::nextafter(1.0, 0.0));
  CHECK(convex_hull(cube).vertices.size() == 8);
  cube.back().z() = std::nextafter(1.0, 2.0);
  CHECK(convex_hull(cube).vertices.size() == 9);
}

TEST_CASE("convex_hull: both zeros are one point") {
  const Polytope p = convex_hull({{0, 0, 0}, {-0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -0.0, 0}});
  CHECK(p.vertices.size() == 4);
}

}  // namespace
}  // namespace touchstone::reference
