#include "reference/certificate.h"

#include <algorithm>
#include <cmath>

#include "reference/convex_hull.h"
#include "reference/distance.h"
#include "reference/penetration.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::body;
using tests::pair;

/// One scene for each kind of proof, boxes a quarter of a unit apart or in each other.
Scene scene_of(Verdict verdict) {
  const double gap = verdict == Verdict::separated ? 0.25 : verdict == Verdict::touching ? 0.0 : -0.25;
  return pair(body(Box{Vec3(1, 1, 1)}, Vec3(0.5, 0.25, 2 + gap)), body(Box{Vec3(1, 1, 1)}));
}

TEST_CASE("certificate: every verdict on every near-degenerate family is proved") {
  tests::Dice dice(5);
  for (int i = 0; i < 40 * tests::hard_families; ++i) {
    const Scene scene = tests::hard_pair(i % tests::hard_families, dice);
    CAPTURE(i);
    const Certificate c = distance(scene).certificate;
    REQUIRE(check(c, scene) == "");
    REQUIRE(c.pairs.size() <= 8);
  }
}

TEST_CASE("certificate: a certificate that is tampered with is refused") {
  const Verdict verdict = GENERATE(Verdict::separated, Verdict::touching, Verdict::overlapping);
  CAPTURE(static_cast<int>(verdict));
  const Scene scene = scene_of(verdict);
  Certificate c = distance(scene).certificate;
  REQUIRE(c.cores == verdict);
  REQUIRE(check(c, scene) == "");

  SECTION("another verdict") {
    for (const Verdict other : {Verdict::separated, Verdict::touching, Verdict::overlapping}) {
      c.cores = other;
      if (other != verdict) CHECK(check(c, scene) != "");
    }
  }
  SECTION("another part of A") {
    c.part_A = 1;
    CHECK(check(c, scene) != "");
  }
  SECTION("another part of B") {
    c.part_B = -1;
    CHECK(check(c, scene) != "");
  }
  SECTION("another direction") {
    c.direction.x += Rational(0x1p-1000);
    CHECK(check(c, scene) != "");
  }
  SECTION("the opposite direction") {
    c.direction = {-c.direction.x, -c.direction.y, -c.direction.z};
    if (verdict != Verdict::overlapping) CHECK(check(c, scene) != "");
  }
  SECTION("another vertex") {
    c.pairs[0].first ^= 4;
    CHECK(check(c, scene) != "");
  }
  SECTION("a vertex that is not there") {
    const int index = GENERATE(-1, 8);
    (GENERATE(true, false) ? c.pairs[0].first : c.pairs[0].second) = index;
    CHECK(check(c, scene) == "it names a vertex that is not there");
  }
  SECTION("another weight") {
    c.weights[0] += Rational(0x1p-1000);
    CHECK(check(c, scene) != "");
  }
  SECTION("a negative weight that cancels") {
    c.pairs.push_back(c.pairs[0]);
    c.weights.push_back(c.weights[0] + Rational(1));
    c.weights[0] = Rational(-1);
    CHECK(check(c, scene) != "");
  }
  SECTION("a pair less") {
    c.pairs.pop_back();
    CHECK(check(c, scene) != "");
    c.weights.pop_back();
    CHECK(check(c, scene) != "");
  }
  SECTION("nothing at all") {
    c.pairs.clear();
    c.weights.clear();
    CHECK(check(c, scene) != "");
  }
  SECTION("of another scene") {
    for (const Verdict other : {Verdict::separated, Verdict::touching, Verdict::overlapping}) {
      if (other != verdict) CHECK(check(c, scene_of(other)) != "");
    }
  }
}

TEST_CASE("certificate: a common point on the boundary is no proof of an overlap") {
  const Scene scene = scene_of(Verdict::touching);
  Certificate c = distance(scene).certificate;
  c.cores = Verdict::overlapping;
  c.direction = {};
  CHECK(check(c, scene) == "the pairs lie in a plane, so the common point may be on the boundary");
}

// Each of these meets every condition but one.
TEST_CASE("certificate: weights that do not add up to 1 prove no distance, and no common point") {
  const Scene scene = scene_of(Verdict::separated);
  Certificate half = distance(scene).certificate;
  for (Rational& weight : half.weights) weight /= 2;
  for (Rational* x : {&half.direction.x, &half.direction.y, &half.direction.z}) *x /= 2;
  CHECK(check(half, scene) == "the weights do not add up to 1");

  const Scene common = scene_of(Verdict::overlapping);
  Certificate twice = distance(common).certificate;
  for (Rational& weight : twice.weights) weight *= 2;
  CHECK(check(twice, common) == "the weights do not add up to 1");
}

TEST_CASE("certificate: pairs of weight 0 do not make a common point an overlap") {
  const Scene scene = scene_of(Verdict::touching);
  Certificate c = distance(scene).certificate;
  c.cores = Verdict::overlapping;
  c.direction = {};
  for (int vertex = 0; vertex < 8; ++vertex) {
    c.pairs.emplace_back(vertex, 0);
    c.weights.emplace_back(0);
  }
  CHECK(check(c, scene) == "a weight is 0, so 0 may lie on the boundary");
}

TEST_CASE("certificate: a plane through the bodies does not keep them apart") {
  const Scene scene = scene_of(Verdict::touching);
  Certificate c = distance(scene).certificate;
  c.direction = {c.direction.x, c.direction.y + c.direction.z, c.direction.z};
  CHECK(check(c, scene) == "the plane does not keep the bodies apart");
}

TEST_CASE("certificate: parts of a compound stand where their poses and the body's put them") {
  const Quaternion turn{2, 1, 0, 0}, other_turn{3, 1, -2, 1};
  const auto scene_with = [&](const Pose& part) {
    Compound compound{{{Pose{{-4, 0, 0}, {}}, Sphere{1}}, {part, Box{Vec3(1, 2, 0.5)}}}};
    return pair(body(std::move(compound), {1, 0, 0}, turn), body(Box{Vec3(1, 1, 1)}, {3, 2, 6}, other_turn));
  };
  const Scene scene = scene_with({{2, 1, 0}, other_turn});
  const Certificate c = distance(scene).certificate;
  REQUIRE(c.cores == Verdict::separated);
  REQUIRE(c.part_A == 1);
  CHECK(check(c, scene) == "");
  CHECK(check(c, scene_with({{2, 1, 0}, turn})) != "");
  CHECK(check(c, scene_with({{2, 1, 0x1p-1000}, other_turn})) != "");
  for (const int part : {-1, 2}) {
    Certificate elsewhere = c;
    elsewhere.part_A = part;
    CHECK(check(elsewhere, scene) == "it names a part that is not there");
  }
}

TEST_CASE("certificate: the ball within its differences is no larger than the depth") {
  tests::Dice dice(6);
  int overlapping = 0;
  for (int i = 0; i < 10 * tests::hard_families; ++i) {
    const Scene scene = tests::hard_pair(i % tests::hard_families, dice);
    const DistanceTruth truth = distance(scene);
    if (std::ranges::any_of(scene.bodies, [](const Body& b) { return std::holds_alternative<Compound>(b.shape); }))
      continue;
    if (truth.certificate.cores != Verdict::overlapping) continue;
    ++overlapping;
    const double radius = inner_radius(truth.certificate, scene);
    CHECK(radius > 0);
    CHECK(radius <= penetration(scene).depth.hi);
  }
  CHECK(overlapping > 10);
  // Two slivers 256 m from the origin that overlap by 1.2e-16 m: in long doubles 0 was on the other side of a face.
  const Quaternion turn{std::cos(3.5e-7), 0, 0, -std::sin(3.5e-7)};
  Polytope a = convex_hull(
      {{0, -3 * 0x1p-13, -0x1p-10}, {0, -0x1p-12, 0}, {-0x1p-12, -3 * 0x1p-13, 0x1p-10}, {0, -3 * 0x1p-13, 0}});
  Polytope b = convex_hull({{0, -0x1p-13, 0}, {-0x1p-12, 0x1p-13, 0}, {0x1p-12, 0x1p-13, 0}, {0, 0, 0x1p-11}});
  const Scene far = pair(body(a, {0.009277343749715783, -256.003662109375, 0.25}, turn),
                         body(b, {0.00927734375, -256.004150390625, 0.25}, turn));
  const Certificate c = distance(far).certificate;
  REQUIRE(c.cores == Verdict::overlapping);
  CHECK(inner_radius(c, far) > 0);
  CHECK(inner_radius(c, far) <= penetration(far).depth.hi);
}

TEST_CASE("certificate: one body has no pair") {
  Scene scene = scene_of(Verdict::separated);
  const Certificate c = distance(scene).certificate;
  scene.bodies.pop_back();
  CHECK(check(c, scene) == "the scene has no two bodies");
}

TEST_CASE("certificate: a direction that is not the least is no proof of a distance") {
  const Scene scene = scene_of(Verdict::separated);
  Certificate c = distance(scene).certificate;
  c.pairs = {{4, 0}};
  c.weights = {1.0};
  c.direction = {0.5, 0.25, 4.25};
  CHECK(check(c, scene) == "a vertex pair is nearer than the direction says");
}

}  // namespace
}  // namespace touchstone::reference
