// Gift wrapping agrees with CGAL's hull (reference/validity.h) on faces and on what is refused.
#include "oracle/process/hull_faces.h"

#include <random>

#include "model/input_error.h"
#include "oracle/process/orientation.h"
#include "oracle/truth/truth.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

using Faces = std::vector<std::vector<int>>;

/// The faces, or the end of the message that refuses the vertices.
std::pair<Faces, std::string> by_wrapping(const std::vector<Vec3>& vertices) try {
  return {hull_faces(vertices), ""};
} catch (const InputError& error) {
  return {{}, error.what()};
}

std::pair<Faces, std::string> by_reference(const std::vector<Vec3>& vertices) try {
  Scene scene;
  scene.bodies.emplace_back().shape = Polytope{vertices, {}};
  return {std::get<Polytope>(truth::completed(scene).bodies[0].shape).faces, ""};
} catch (const InputError& error) {
  return {{}, std::string(error.what()).substr(std::string("bodies[0].shape.").size())};
}

std::vector<Vec3> each_once(const std::vector<Vec3>& points) {
  std::vector<Vec3> once;
  for (const Vec3& p : points) {
    if (std::find(once.begin(), once.end(), p) == once.end()) once.push_back(p);
  }
  return once;
}

TEST_CASE("derived faces are the reference's") {
  std::mt19937 bits(1);
  int solids = 0;
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    // A small grid: many vertices share planes and lines, and some hulls are flat or have a vertex inside.
    const int extent = 1 + static_cast<int>(bits() % 4);
    const double unit = round % 3 == 0 ? 1 : round % 3 == 1 ? 0x1p-530 : 0x1p+330;
    std::vector<Vec3> points;
    for (int i = 0; i < 4 + round % 9; ++i) {
      Vec3 p;
      for (double& x : p) x = unit * (static_cast<int>(bits() % static_cast<unsigned>(2 * extent + 1)) - extent);
      points.push_back(p);
    }
    points = each_once(points);
    if (points.size() < 4) continue;
    CAPTURE(round);
    const auto wrapped = by_wrapping(points);
    REQUIRE(wrapped == by_reference(points));
    ++(wrapped.second.empty() ? solids : refused);
  }
  CHECK(solids > 300);
  CHECK(refused > 300);
}

TEST_CASE("derived faces of round hulls are the reference's") {
  std::mt19937 bits(2);
  for (const int count : {10, 40, 120}) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
      Vec3 p;
      for (double& x : p) x = static_cast<double>(bits()) * 0x1p-31 - 1;
      points.push_back(p.normalized());
    }
    CHECK(by_wrapping(points) == by_reference(points));
  }
}

TEST_CASE("orientation is exact where doubles are not") {
  const double tiny = 5e-324;
  const double huge = 1e308;
  CHECK(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, tiny}) == 1);
  CHECK(orientation({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, -tiny}) == -1);
  CHECK(orientation({-huge, 0, 0}, {huge, 0, 0}, {0, huge, 0}, {0, 0, huge}) == 1);
  CHECK(orientation({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.4, 0.4, 0.4}, {1, 2, 3}) == 0);
  CHECK(collinear({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.4, 0.4, 0.4}));
  CHECK_FALSE(collinear({0, 0, 0}, {huge, 0, 0}, {-huge, tiny, 0}));
}

}  // namespace
}  // namespace touchstone::oracle
