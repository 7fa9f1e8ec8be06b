#include "reference/penetration.h"

#include <limits>

#include "model/input_error.h"
#include "reference/distance.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::body;
using tests::Dice;
using tests::pair;

const double ulp = std::numeric_limits<double>::epsilon();

/// Both routes agree, and this is what they say.
PenetrationTruth agreed(const Scene& scene) {
  const PenetrationTruth truth = penetration(scene);
  const PenetrationTruth hull = penetration(scene, DepthRoute::minkowski_hull);
  CHECK(truth.verdict == hull.verdict);
  CHECK(truth.core_squared == hull.core_squared);
  CHECK(truth.cores_overlap == hull.cores_overlap);
  CHECK(truth.depth == hull.depth);
  return truth;
}

bool positive_multiple(const RationalVec3& v, double x, double y, double z) {
  const Rational along = v.x * Rational(x) + v.y * Rational(y) + v.z * Rational(z);
  const auto parallel = [](const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
    return a * d == b * c;
  };
  return along.sign() > 0 && parallel(v.x, v.y, x, y) && parallel(v.y, v.z, y, z) && parallel(v.x, v.z, x, z);
}

TEST_CASE("depth: boxes: the least of six ways out") {
  const PenetrationTruth t = agreed(pair(body(Box{Vec3(1, 1, 1)}, Vec3(0.5, 0, 1.25)), body(Box{Vec3(1, 2, 1)})));
  CHECK(t.verdict == Verdict::overlapping);
  CHECK(t.depth == Interval{0.75, 0.75});
  CHECK(t.core_squared == Rational("9/16"));
  CHECK(positive_multiple(t.direction, 0, 0, 1));
  CHECK(t.nhat_BA_W == Vec3(0, 0, 1));
}

TEST_CASE("depth: edge to edge: the way out is the edges' cross product") {
  // Beams along x and y, each turned about itself by cos = 21/29, sin = 20/29: their upper and lower edges reach 41/29
  // along z.
  const Scene scene = pair(body(Box{Vec3(4, 1, 1)}, Vec3(0, 0, 2.5), {5, 2, 0, 0}),
                           body(Box{Vec3(1, 4, 1)}, Vec3::Zero(), {5, 0, 2, 0}));
  const PenetrationTruth t = agreed(scene);
  CHECK(t.verdict == Verdict::overlapping);
  CHECK(positive_multiple(t.direction, 0, 0, 1));
  const Rational depth = Rational("82/29") - Rational(2.5);
  CHECK(t.core_squared == depth * depth);
}

TEST_CASE("depth: a face of a rotated box") {
  // cos = 3/5, sin = 4/5 about z; the box's own axis (3/5, 4/5, 0) is the way out: 2 − 1.5 = 0.5 deep.
  const Scene scene = pair(body(Box{Vec3(1, 1, 1)}, Vec3(0.9, 1.2, 0), {2, 0, 0, 1}),
                           body(Box{Vec3(1, 1, 1)}, Vec3::Zero(), {2, 0, 0, 1}));
  const PenetrationTruth t = agreed(scene);
  CHECK(positive_multiple(t.direction, 3, 4, 0));
  CHECK(t.nhat_BA_W.isApprox(Vec3(0.6, 0.8, 0), 4 * ulp));
  CHECK(t.depth.lo == Approx(0.5).margin(4 * ulp));
}

TEST_CASE("depth: apart and touching bodies have no depth") {
  const PenetrationTruth apart = agreed(pair(body(Box{Vec3(1, 1, 1)}, Vec3(3, 0, 0)), body(Box{Vec3(1, 1, 1)})));
  CHECK(apart.verdict == Verdict::separated);
  CHECK(apart.depth == Interval{0, 0});
  CHECK(apart.core_squared == Rational(1));
  const PenetrationTruth touching = agreed(pair(body(Box{Vec3(1, 1, 1)}, Vec3(2, 0, 0)), body(Box{Vec3(1, 1, 1)})));
  CHECK(touching.verdict == Verdict::touching);
  CHECK(touching.depth == Interval{0, 0});
  CHECK(touching.nhat_BA_W == Vec3(1, 0, 0));
}

TEST_CASE("depth: spheres") {
  SECTION("centres apart") {
    const PenetrationTruth t = agreed(pair(body(Sphere{4}, Vec3(3, 4, 0)), body(Sphere{2})));
    CHECK(t.depth == Interval{1, 1});
    CHECK(!t.cores_overlap);
    CHECK(positive_multiple(t.direction, 3, 4, 0));
  }
  SECTION("concentric: any way is as short") {
    const PenetrationTruth t = agreed(pair(body(Sphere{4}, Vec3(3, 4, 0)), body(Sphere{2}, Vec3(3, 4, 0))));
    CHECK(t.depth == Interval{6, 6});
    CHECK(t.nhat_BA_W.norm() == 1);
  }
  SECTION("a centre inside a box") {
    const PenetrationTruth t = agreed(pair(body(Sphere{0.5}, Vec3(0, 0.75, 0)), body(Box{Vec3(1, 1, 1)})));
    CHECK(t.depth == Interval{0.75, 0.75});
    CHECK(t.cores_overlap);
    CHECK(positive_multiple(t.direction, 0, 1, 0));
  }
  SECTION("a box around a centre: the direction is A's") {
    const PenetrationTruth t = agreed(pair(body(Box{Vec3(1, 1, 1)}), body(Sphere{0.5}, Vec3(0, 0.75, 0))));
    CHECK(t.depth == Interval{0.75, 0.75});
    CHECK(positive_multiple(t.direction, 0, -1, 0));
  }
  SECTION("a centre on a face") {
    const PenetrationTruth t = agreed(pair(body(Sphere{0.5}, Vec3(0, 1, 0)), body(Box{Vec3(1, 1, 1)})));
    CHECK(t.verdict == Verdict::overlapping);
    CHECK(t.depth == Interval{0.5, 0.5});
    CHECK(positive_multiple(t.direction, 0, 1, 0));
  }
  SECTION("a centre above a vertex, an irrational depth: the tightest doubles") {
    const PenetrationTruth t = agreed(pair(body(Sphere{2}, Vec3(2, 2, 2)), body(Box{Vec3(1, 1, 1)})));
    CHECK(t.core_squared == Rational(3));  // depth 2 − √3
    CHECK(std::nextafter(t.depth.lo, 1) == t.depth.hi);
    const auto rest_squared = [](double depth) {
      return (Rational(2) - Rational(depth)) * (Rational(2) - Rational(depth));
    };
    CHECK(rest_squared(t.depth.lo) > Rational(3));
    CHECK(rest_squared(t.depth.hi) < Rational(3));
  }
}

TEST_CASE("depth: coplanar neighbouring faces are one face") {
  Polytope split = convex_hull({Vec3(-1, -1, -1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(1, 1, -1), Vec3(-1, -1, 1),
                                Vec3(1, -1, 1), Vec3(-1, 1, 1), Vec3(1, 1, 1)});
  std::vector<std::vector<int>> triangles;
  for (const auto& face : split.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) triangles.push_back({face[0], face[i - 1], face[i]});
  }
  split.faces = triangles;
  const Scene whole = pair(body(Box{Vec3(1, 1, 1)}, Vec3(0.5, 0.25, 1.5), {3, 1, 0, 0}), body(Box{Vec3(1, 1, 1)}));
  Scene cut = whole;
  cut.bodies[1].shape = split;
  CHECK(agreed(cut).core_squared == agreed(whole).core_squared);
}

TEST_CASE("depth: the two routes agree on the near-degenerate families") {
  Dice dice(7);
  int overlaps = 0;
  for (int i = 0; i < 500; ++i) {
    const int families[] = {0, 1, 2, 3, 4, 5, 10, 11, 13};
    Scene scene = tests::hard_pair(families[i % 9], dice);
    scene.bodies[0].X_WB.p_WB = 0.5 * (scene.bodies[0].X_WB.p_WB + scene.bodies[1].X_WB.p_WB);
    CAPTURE(i);
    const PenetrationTruth gauss = penetration(scene);
    const PenetrationTruth hull = penetration(scene, DepthRoute::minkowski_hull);
    REQUIRE(gauss.verdict == hull.verdict);
    REQUIRE(gauss.core_squared == hull.core_squared);
    REQUIRE(gauss.depth == hull.depth);
    REQUIRE(gauss.verdict == distance(scene).verdict);
    overlaps += gauss.verdict == Verdict::overlapping ? 1 : 0;
  }
  CHECK(overlaps > 200);
}

TEST_CASE("depth: identical bodies in one place: every way ties, both routes find the least") {
  Dice dice(8);
  for (int i = 0; i < 10; ++i) {
    const Shape shape = tests::lattice_hull(dice, 10, 3);
    const PenetrationTruth t = agreed(pair(body(shape, Vec3(1, 2, 3)), body(shape, Vec3(1, 2, 3))));
    CHECK(t.depth.lo > 0);
  }
}

TEST_CASE("depth: moving A out along the direction by the depth leaves nothing, by half of it, half") {
  Dice dice(9);
  for (int i = 0; i < 30; ++i) {
    const Scene scene =
        tests::pair_of({{tests::round_hull(dice, 20), 0.5 * dice.in_cube(), tests::integer_quaternion(dice)},
                        {tests::round_hull(dice, 20)}});
    const PenetrationTruth t = penetration(scene);
    REQUIRE(t.verdict == Verdict::overlapping);
    CHECK(depth_after(scene, Vec3::Zero()) == t.depth);
    CHECK(depth_after(scene, t.depth.hi * t.nhat_BA_W).hi <= 8 * ulp);
    CHECK(depth_after(scene, 0.5 * t.depth.hi * t.nhat_BA_W).hi == Approx(0.5 * t.depth.hi).epsilon(1e-14));
    CHECK(depth_after(scene, 0.99 * t.depth.hi * dice.in_cube().normalized()).lo > 0);
  }
  const Scene boxes = pair(body(Box{Vec3(1, 1, 1)}, Vec3(1.5, 0, 0)), body(Box{Vec3(1, 1, 1)}));
  CHECK(depth_after(boxes, Vec3(0.5, 0, 0)) == Interval{0, 0});
  CHECK(depth_after(boxes, Vec3(0.5 - 0x1p-60, 0, 0)) == Interval{0, 0});  // 0.5 − 2⁻⁶⁰ is the double 0.5
  CHECK(depth_after(boxes, Vec3(0.5 - 0x1p-54, 0, 0)) == Interval{0x1p-54, 0x1p-54});
}

TEST_CASE("depth: a compound is refused") {
  Compound compound;
  compound.parts.push_back({{}, Sphere{1}});
  CHECK_THROWS_AS(penetration(pair(body(Sphere{1}), body(compound))), InputError);
}

}  // namespace
}  // namespace touchstone::reference
