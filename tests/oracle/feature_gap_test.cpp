#include "oracle/truth/feature_gap.h"

#include "tests/catch.h"

using namespace touchstone;
using oracle::feature_gap;
using oracle::off_one_face;

namespace {

Body posed(Shape shape, const Vec3& p_WB, const Quaternion& q_WB = {}) {
  Body body;
  body.shape = std::move(shape);
  body.X_WB = {p_WB, q_WB};
  return body;
}

const Body cube = posed(Box{{1, 1, 1}}, {0, 0, 0});
const Body above = posed(Box{{1, 1, 1}}, {0.5, 0.25, 3});

}  // namespace

TEST_CASE("feature_gap: vertices, edges and faces, in any order of their vertices") {
  CHECK(*feature_gap(cube, {0, {4, 5, 6, 7}}, above, {0, {0, 1, 2, 3}}) == 1);
  CHECK(*feature_gap(cube, {0, {7, 4, 6, 5}}, above, {0, {0}}) == 1);                         // a vertex over the face
  CHECK(*feature_gap(cube, {0, {5, 7}}, above, {0, {0, 1}}) == 1);                            // crossed edges
  CHECK(*feature_gap(cube, {0, {4, 5}}, above, {0, {0, 1}}) == Approx(std::hypot(1, 0.25)));  // parallel edges
  CHECK(*feature_gap(cube, {0, {7}}, above, {0, {0}}) == Approx(Vec3(1.5, 1.75, 1).norm()));
}

TEST_CASE("feature_gap: hulls that cross are 0 apart, a sphere is its centre, poses of parts count") {
  const Body through = posed(Box{{0.5, 0.5, 4}}, {0, 0, 0});
  CHECK(*feature_gap(cube, {0, {4, 5, 6, 7}}, through, {0, {0, 4}}) == Approx(0.5 * 0).margin(1e-15));
  const Body ball = posed(Sphere{1}, {0, 0, 5});
  CHECK(*feature_gap(cube, {0, {4, 5, 6, 7}}, ball, {0, {0}}) == 4);
  const Body turned =
      posed(Compound{{{Pose{}, Sphere{1}}, {Pose{{2, 0, 0}, {}}, Sphere{1}}}}, {0, 0, 1}, {1, 0, -1, 0});
  CHECK(*feature_gap(cube, {0, {4, 5, 6, 7}}, turned, {1, {0}}) == Approx(2));  // x rotated to z: the part at (0, 0, 3)
}

TEST_CASE("feature_gap: long edges that cross at a hundred thousandth of a right angle do cross") {
  const Body A = posed(Polytope{{{0, 0, 2}, {0, 0, 0}, {32768, 3, 0}, {-32768, 4, 0}}, {}}, {0, 0, 0});
  const Body B =
      posed(Polytope{{{0, -2, -524288}, {0, 0, -524288}, {-4194304, -4, 0}, {1572864, 6, 0}}, {}}, {0, 0, 0});
  CHECK(*feature_gap(A, {0, {2, 3}}, B, {0, {2, 3}}) < 1e-12);
}

TEST_CASE("feature_gap: edges that cross at 2^-36 of a radian do cross") {
  const Polytope bar{{{-0.375, -0.25, -1}, {0, 0, 0}, {0, 0.25, 0}, {-0.375, -0.25, 1}}, {}};
  const Body turned = posed(bar, {0, 0, 0}, {1, 0, -0x1p-37, 0});
  CHECK(*feature_gap(turned, {0, {0, 3}}, posed(bar, {0, 0, 0}), {0, {0, 3}}) < 1e-18);
  CHECK(*feature_gap(turned, {0, {0, 3}}, posed(bar, {0, -1, 0}), {0, {0, 3}}) == Approx(1));
}

TEST_CASE("feature_gap: a point beyond a side of a triangle is as far as that side") {
  const Body corner = posed(Polytope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {}}, {0, 0, 0});
  const auto gap = [&](const Vec3& p) { return *feature_gap(corner, {0, {0, 1, 2}}, posed(Sphere{1}, p), {0, {0}}); };
  CHECK(gap({1, 1, 1}) == Approx(std::sqrt(1.5)));
  CHECK(gap({0.25, -0.5, 1}) == Approx(std::sqrt(1.25)));
  CHECK(gap({-0.5, 0.25, 1}) == Approx(std::sqrt(1.25)));
  CHECK(gap({0.25, 0.25, 1}) == 1);
}

TEST_CASE("feature_gap: what is not there has no gap") {
  CHECK_FALSE(feature_gap(cube, {0, {8}}, above, {0, {0}}));
  CHECK_FALSE(feature_gap(cube, {0, {-1}}, above, {0, {0}}));
  CHECK_FALSE(feature_gap(cube, {1, {0}}, above, {0, {0}}));
  CHECK_FALSE(feature_gap(cube, {0, {}}, above, {0, {0}}));
}

TEST_CASE("off_one_face: 0 for a vertex, an edge, a face or a part of one, else how far it is from a face") {
  for (const std::vector<int>& vertices :
       {std::vector<int>{3}, {0, 7}, {4, 5, 6, 7}, {7, 4, 6}, {0, 1, 4, 5}, std::vector<int>{}})
    CHECK(off_one_face(cube, {0, vertices}) == 0);
  CHECK(off_one_face(cube, {0, {4, 5, 6, 7, 0}}) == Approx(2));  // a vertex of the opposite face, 2 m behind
  CHECK(off_one_face(cube, {0, {0, 1, 6, 7}}) == Approx(std::sqrt(2)));
}

// Found by fuzzing: rounding of world coordinates by 4e-10 m tilts a triangle that is 4 m high by as much, and 4e9 m
// away the plane is off by 0.04 m.
TEST_CASE("off_one_face: of a face that is 10⁹ times as long as high") {
  Polytope sliver;
  sliver.vertices = {{-0x1p32, 0, 0}, {0, -4, 0}, {0x1p31, 0, 2}, {0, 0, 2}};
  const Body body = posed(sliver, {0, 0, 0}, {0, 1, -1, 2});
  for (std::vector<int> vertices : {std::vector<int>{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}})
    CHECK(off_one_face(body, {0, vertices}) < 1e-9);
  sliver.vertices.push_back({0, 0, -0x1p-10});
  CHECK(off_one_face(posed(sliver, {0, 0, 0}, {0, 1, -1, 2}), {0, {0, 1, 2, 4}}) > 0x1p-11);
}

// Found by fuzzing: a side of 6e-11 m between two of 1 m, whose cross product is off by rounding of 1 m.
TEST_CASE("off_one_face: of a sliver no more than rounding of its least side's direction") {
  Polytope sliver;
  sliver.vertices = {{0, 0, 0}, {0, 0, 0x1p-40}, {0x1p-34, 0, 0x1p-40}, {0, -1, 0x1p-40}};
  const Body body = posed(sliver, {0, -0x1p-7, 0}, {-0.25, 0.125, -1, -0.75});
  for (std::vector<int> vertices : {std::vector<int>{1, 2, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}})
    CHECK(off_one_face(body, {0, vertices}) < 0x1p-62);
}
