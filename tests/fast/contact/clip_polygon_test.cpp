// Clipping by one half-space: squares, segments and points whose clipped parts are known.
#include "fast/contact/clip_polygon.h"

#include <Eigen/Core>

#include "tests/catch.h"

namespace touchstone::fast::contact {
namespace {

using Vec2 = Eigen::Vector2d;
using Polygon = std::vector<Vec2>;

const Polygon square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

TEST_CASE("clip_polygon: a square is cut in the middle, in order around it") {
  const Polygon left = clip_polygon(square, [](const Vec2& p) { return 1 - p.x(); });
  CHECK(left == Polygon{{0, 0}, {1, 0}, {1, 2}, {0, 2}});
}

TEST_CASE("clip_polygon: a corner that is cut off leaves five corners") {
  const Polygon rest = clip_polygon(square, [](const Vec2& p) { return 3 - p.x() - p.y(); });
  CHECK(rest == Polygon{{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}});
}

TEST_CASE("clip_polygon: what is inside stays as it is, what is outside is gone, a border counts as inside") {
  CHECK(clip_polygon(square, [](const Vec2& p) { return p.x() + 1; }) == square);
  CHECK(clip_polygon(square, [](const Vec2& p) { return -1 - p.x(); }).empty());
  CHECK(clip_polygon(square, [](const Vec2& p) { return -p.x(); }) == Polygon{{0, 0}, {0, 2}});
}

TEST_CASE(
    "clip_polygon: a segment is passed there and back, so its crossing is returned twice, last from the far end") {
  const Polygon segment = {{0, 0}, {4, 0}};
  CHECK(clip_polygon(segment, [](const Vec2& p) { return 1 - p.x(); }) == Polygon{{0, 0}, {1, 0}, {1, 0}});
  CHECK(clip_polygon(segment, [](const Vec2& p) { return p.x() - 1; }) == Polygon{{1, 0}, {4, 0}, {1, 0}});
}

TEST_CASE("clip_polygon: a point is kept or not, nothing stays nothing") {
  CHECK(clip_polygon(Polygon{{1, 1}}, [](const Vec2& p) { return p.x(); }).size() == 1);
  CHECK(clip_polygon(Polygon{{1, 1}}, [](const Vec2& p) { return -p.x(); }).empty());
  CHECK(clip_polygon(Polygon{}, [](const Vec2& p) { return p.x(); }).empty());
}

}  // namespace
}  // namespace touchstone::fast::contact
