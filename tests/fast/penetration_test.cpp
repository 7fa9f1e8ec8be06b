// Verdict, enclosure, depth and direction against the exact reference in hard cases, asked once and followed.
#include "fast/penetration.h"

#include <cmath>

#include "fast/mark.h"
#include "fast/rounding.h"
#include "model/input_error.h"
#include "reference/penetration.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast {
namespace {

using tests::Dice;

/// A length that no point of the pair in A's frame exceeds.
double reach(const Scene& scene) {
  double most = (scene.bodies[1].X_WB.p_WB - scene.bodies[0].X_WB.p_WB).norm();
  for (const Body& body : scene.bodies) {
    if (const auto* sphere = std::get_if<Sphere>(&body.shape)) most += sphere->radius;
    if (const auto* box = std::get_if<Box>(&body.shape)) most += box->half_extents.norm();
    const auto* polytope = std::get_if<Polytope>(&body.shape);
    if (!polytope) continue;
    double farthest = 0;
    for (const Vec3& v : polytope->vertices) farthest = std::max(farthest, v.norm());
    most += farthest;
  }
  return most;
}

/// The depth is off by less than its enclosure is wide: nine times rounding(A, B) ≤ 26u of the reach
/// (lin_canny/bracket.h), so 234u, and 4u of the sums with radii.
void check(const Scene& scene, const PenetrationDepth& said) {
  const reference::PenetrationTruth truth = reference::penetration(scene);
  REQUIRE(said.answer.verdict == truth.verdict);
  REQUIRE(said.enclosure.lo <= truth.depth.lo);
  REQUIRE(said.enclosure.hi >= truth.depth.hi);
  REQUIRE(*said.answer.depth >= said.enclosure.lo);
  REQUIRE(*said.answer.depth <= said.enclosure.hi);
  REQUIRE(said.answer.nhat_BA_W.has_value() == (truth.verdict == Verdict::overlapping));
  if (!said.answer.nhat_BA_W) return;
  const double allowed = 256 * u * reach(scene);
  REQUIRE(said.enclosure.hi - said.enclosure.lo <= allowed);
  const Vec3& n = *said.answer.nhat_BA_W;
  REQUIRE(std::abs(n.norm() - 1) <= 6 * u);
  REQUIRE(reference::depth_after(scene, *said.answer.depth * n).lo <= allowed);
}

bool has_compound(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const Body& b) { return std::holds_alternative<Compound>(b.shape); });
}

TEST_CASE(
    "hard pairs of all families: the exact verdict, a narrow enclosure of the depth, a direction that separates") {
  Dice dice(31);
  for (int i = 0; i < 40 * tests::hard_families; ++i) {
    const Scene scene = tests::hard_pair(i % tests::hard_families, dice);
    if (!has_compound(scene)) check(scene, penetration_depth(scene));
  }
}

TEST_CASE("needles and plates to 1e6, at scales of 1e±100") {
  Dice dice(32);
  for (int i = 0; i < 60; ++i) {
    const double thin = std::pow(10, -dice.between(0, 6));
    const Polytope needle = tests::stretched(tests::round_hull(dice, 10), Vec3(1, thin, thin));
    const Polytope plate = tests::stretched(tests::round_hull(dice, 10), Vec3(1, 1, thin));
    Scene scene = tests::pair_of({{needle, 0.5 * dice.in_cube(), tests::integer_quaternion(dice)},
                                  {plate, Vec3::Zero(), tests::integer_quaternion(dice)}});
    check(scene, penetration_depth(scene));
    tests::scale(scene, -332);
    check(scene, penetration_depth(scene));
    tests::scale(scene, 664);
    check(scene, penetration_depth(scene));
  }
}

TEST_CASE("spheres: with a common centre, on a face, on an edge, and in a corner of a box") {
  const Sphere ball{0.5};
  const Box box{Vec3(1, 2, 3)};
  check(tests::pair_of({{ball}, {Sphere{2}}}), penetration_depth(tests::pair_of({{ball}, {Sphere{2}}})));
  for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 2, 0), Vec3(1, 2, 3), Vec3(1.25, 2, 3),
                             Vec3(0x1.0000000000001p0, 2, 0), Vec3(1.25, 2.25, 3.25), Vec3(1.5, 0, 0), Vec3(2, 0, 0)}) {
    for (const Scene& scene : {tests::pair_of({{ball, centre}, {box}}), tests::pair_of({{box}, {ball, centre}})}) {
      check(scene, penetration_depth(scene));
    }
  }
}

// Found by `touchstone fuzz`: witness points in W, at 2^31 m, gave any direction.
TEST_CASE("a large ball whose centre is 1e-12 m from a small polytope, far from the origin") {
  const Polytope small{{{16, 0, 0}, {16, 0, 16}, {0, -16, 0}, {0, 0, -0x1p-39}},
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  for (const double x : {0.0, 2147483620.0}) {
    const Vec3 place(x, 32, 8);
    for (const Scene& scene : {tests::pair_of({{Sphere{8192}, place}, {small, place}}),
                               tests::pair_of({{small, place}, {Sphere{8192}, place}})}) {
      check(scene, penetration_depth(scene));
    }
  }
}

TEST_CASE("two hulls that are followed: what is kept of a pose changes no bound that matters") {
  Dice dice(33);
  for (const int vertices : {8, 20, 60}) {
    const Polytope A = tests::round_hull(dice, vertices), B = tests::round_hull(dice, vertices);
    PenetrationPair pair(A, B);
    for (int frame = 0; frame < 120; ++frame) {
      const double t = 0.05 * frame, jump = frame % 40 == 39 ? 2 : 0;  // separated now and then
      const Vec3 place(1 + 0.5 * std::sin(t) + jump, 0.4 * std::sin(0.7 * t), 0.3 * std::cos(t));
      const Scene scene = tests::pair_of({{A, Vec3::Zero(), {std::cos(t / 2), std::sin(t / 2), 0, 0}},
                                          {B, place, {std::cos(0.3 * t), 0, std::sin(0.3 * t), 0}}});
      check(scene, pair.at(scene.bodies[0].X_WB, scene.bodies[1].X_WB));
    }
  }
}

// The polytope that is kept from the last pose must be worth it: certificates hide one that is not.
TEST_CASE("two hulls that are followed need fewer than half of the steps of new pairs, and no exact search") {
  const auto steps = [] { return mark_counts[static_cast<std::size_t>(Mark::depth_step)]; };
  const auto exact = mark_counts[static_cast<std::size_t>(Mark::depth_exact)];
  Dice dice(34);
  const Polytope A = tests::round_hull(dice, 40), B = tests::round_hull(dice, 24);
  PenetrationPair pair(A, B);
  std::uint64_t followed = 0, fresh = 0;
  for (int frame = 0; frame < 100; ++frame) {
    const double t = 0.002 * frame;
    const Pose at_A{Vec3::Zero(), {std::cos(t), std::sin(t), 0, 0}}, at_B{{1 + 0.1 * t, 0.4 * t, 0.3}, {1, 0, t, 0}};
    std::uint64_t before = steps();
    pair.at(at_A, at_B);
    followed += steps() - before;
    before = steps();
    PenetrationPair(A, B).at(at_A, at_B);
    fresh += steps() - before;
  }
  CAPTURE(followed, fresh);
  CHECK(2 * followed < fresh);
  CHECK(mark_counts[static_cast<std::size_t>(Mark::depth_exact)] == exact);
}

TEST_CASE("compounds, single bodies and depths beyond doubles are refused") {
  Compound compound;
  compound.parts.push_back({{}, Sphere{1}});
  CHECK_THROWS_AS(penetration_depth(tests::pair_of({{Sphere{1}}, {compound}})), InputError);
  Scene one = tests::pair_of({{Sphere{1}}, {Sphere{1}}});
  one.bodies.pop_back();
  CHECK_THROWS_AS(penetration_depth(one), InputError);
  CHECK_THROWS_AS(penetration_depth(tests::pair_of({{Sphere{1.5e308}}, {Sphere{1.5e308}}})), std::range_error);
}

}  // namespace
}  // namespace touchstone::fast
