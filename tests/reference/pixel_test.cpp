// Pixels by hand, and against the exact distance: bodies meet above some square of a raster that holds them all exactly
// if they are not apart, and a square meets a picture exactly if the endless prism over it is not apart from the body.
#include "reference/pixel.h"

#include <limits>

#include "reference/distance.h"
#include "reference/validity.h"
#include "tests/catch.h"

using namespace touchstone;

namespace {

Body at(Shape shape, const Vec3& p, const Quaternion& q = {}) {
  Body body;
  body.shape = std::move(shape);
  body.X_WB = {p, q};
  return body;
}

Scene scene(std::vector<Body> bodies, const Raster& raster) {
  Scene made;
  made.bodies = std::move(bodies);
  made.raster = raster;
  return reference::completed(made);
}

bool any(const Mask& mask) {
  for (const std::string& row : mask) {
    if (row.find('1') != std::string::npos) return true;
  }
  return false;
}

const Box cube{Vec3::Ones()};
const Polytope tetrahedron{{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}}, {}};
const Raster unit{0, 0, 1, 4, 3, 0, 0};

}  // namespace

TEST_CASE("a cube's corners on centres, and its sides on lines") {
  const Pixels on_centres = reference::pixel(scene({at(cube, {1.5, 1.5, 0})}, unit));  // [0.5, 2.5]²
  CHECK(on_centres.sampled[0] == Mask{"1110", "1110", "1110"});
  CHECK(on_centres.conservative[0] == Mask{"1110", "1110", "1110"});
  const Pixels on_lines = reference::pixel(scene({at(cube, {2, 1, 0})}, unit));  // [1, 3] × [0, 2]
  CHECK(on_lines.sampled[0] == Mask{"0110", "0110", "0000"});
  CHECK(on_lines.conservative[0] == Mask{"1111", "1111", "1111"});
  CHECK_FALSE(any(on_lines.meet_conservative));
  CHECK(on_lines.overlap == MaskOverlap{});
}

TEST_CASE("a disc through centres and up to a line, to the last bit") {
  // The centre (2.5, 1.5) is 1 away from (1.5, 1.5), the square from x = 3 on is 1.5 away.
  const Raster& r = unit;
  CHECK(reference::pixel(scene({at(Sphere{1}, {1.5, 1.5, 0})}, r)).sampled[0] == Mask{"0100", "1110", "0100"});
  CHECK(reference::pixel(scene({at(Sphere{1 - 0x1p-53}, {1.5, 1.5, 0})}, r)).sampled[0] ==
        Mask{"0000", "0100", "0000"});
  CHECK(reference::pixel(scene({at(Sphere{1.5}, {1.5, 1.5, 0})}, r)).conservative[0] == Mask{"1110", "1111", "1110"});
  CHECK(reference::pixel(scene({at(Sphere{1.5 - 0x1p-52}, {1.5, 1.5, 0})}, r)).conservative[0] ==
        Mask{"1110", "1110", "1110"});
}

TEST_CASE("masks laid over each other: B's is moved by the shift") {
  Raster r{0, 0, 1, 4, 3, 1, 0};
  Scene s = scene({at(cube, {3, 2, 0}), at(cube, {1, 1, 9})}, r);  // [2, 4] × [1, 3] and [0, 2]²
  CHECK(reference::pixel(s).overlap == MaskOverlap{1, std::pair{2, 1}});
  s.raster->shift_x = 2;
  s.raster->shift_y = 1;
  CHECK(reference::pixel(s).overlap == MaskOverlap{4, std::pair{2, 1}});
  s.raster->shift_x = 0;
  CHECK(reference::pixel(s).overlap == MaskOverlap{});
  s.raster->shift_x = std::numeric_limits<int>::min();
  CHECK(reference::pixel(s).overlap == MaskOverlap{});
}

TEST_CASE("depth decides where pictures overlap") {
  const auto meet = [](double z) {
    return reference::pixel(scene({at(cube, {1.5, 1.5, 0}), at(cube, {1.5, 1.5, z})}, unit)).meet_sampled;
  };
  CHECK(any(meet(2)));
  CHECK_FALSE(any(meet(2 + 0x1p-51)));
  CHECK(any(meet(-2)));
}

TEST_CASE("some square has a common point exactly if the bodies are not apart") {
  const std::vector<Shape> shapes = {cube, tetrahedron, Sphere{1}, Box{Vec3(0.25, 3, 0.5)}, Sphere{0.0625}};
  const std::vector<Vec3> places = {{0, 0, 2}, {1.5, 1.5, 1.5}, {0.5, -1, 1.75},
                                    {2, 0, 0}, {1, 1.5, -1.25}, {-1, 1, 1}};
  const std::vector<Quaternion> turns = {{}, {3, 1, -2, 1}, {2, 1, 0, 0}};
  int meeting = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      for (const Vec3& p : places) {
        for (const Quaternion& q : turns) {
          const Scene s = scene({at(a, {0, 0, 0}, turns[1]), at(b, p, q)}, Raster{-8, -8, 0.8125, 20, 20, 0, 0});
          const bool meets = reference::distance(s).verdict != Verdict::separated;
          CHECK(any(reference::pixel(s).meet_conservative) == meets);
          meeting += meets;
        }
      }
    }
  }
  CHECK(meeting > 50);
  CHECK(meeting < 400);
}

TEST_CASE("a square meets a picture exactly if its prism is not apart from the body") {
  const Raster r{-1.5, -2, 0.5, 8, 9, 0, 0};
  for (const Shape& shape : std::vector<Shape>{cube, tetrahedron, Sphere{1}}) {
    for (const Quaternion& q : {Quaternion{}, Quaternion{3, 1, -2, 1}, Quaternion{2, 0, 0, 1}}) {
      const Body body = at(shape, {0.25, 0.125, 7}, q);
      const Mask mask = reference::pixel(scene({body}, r)).conservative[0];
      for (int i = 0; i < r.columns; ++i) {
        for (int j = 0; j < r.rows; ++j) {
          const Body prism = at(Box{Vec3(0.25, 0.25, 1024)}, {r.x + 0.5 * i + 0.25, r.y + 0.5 * j + 0.25, 0});
          const bool meets = reference::distance(scene({body, prism}, r)).verdict != Verdict::separated;
          CHECK((mask[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] == '1') == meets);
        }
      }
    }
  }
}

TEST_CASE("depths that come near") {
  const Scene s = scene({at(Sphere{1}, {1.5, 1.5, 0}), at(cube, {1.5, 1.5, 2.5})}, unit);
  CHECK_FALSE(reference::depths_come_near(s, 1, 1, 0, 0.5 - 0x1p-53));  // the ball's top, the cube's bottom
  CHECK(reference::depths_come_near(s, 1, 1, 0, 0.5));
  CHECK_FALSE(reference::depths_come_near(s, 3, 1, 0, 9.0));
  CHECK(reference::depths_come_near(s, 2, 1, 1, 0.5));
  CHECK_FALSE(reference::depths_come_near(s, 2, 1, 0, 0.63));  // the ball is lower there: √3/2 instead of 1
  CHECK(reference::depths_come_near(s, 2, 1, 0, 0.64));
}
