#include "reference/mass.h"

#include <cmath>

#include "reference/convex_hull.h"
#include "tests/catch.h"
#include "tests/reference/cuboid.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::cuboid;
using tests::Dice;

bool same(const SolidTruth::Value& a, const SolidTruth::Value& b) {
  return a.rational == b.rational && a.pi_multiple == b.pi_multiple;
}

Compound posed(const ConvexShape& shape, const Vec3& p, const Quaternion& q = {}) {
  Compound compound;
  compound.parts.push_back({Pose{p, q}, shape});
  return compound;
}

/// A few ulps at most, and around the rational when there is no π.
void require_thin(const Interval& interval) {
  double hi = interval.lo;
  for (int i = 0; i < 4 && hi < interval.hi; ++i) hi = std::nextafter(hi, INFINITY);
  REQUIRE(interval.lo <= interval.hi);
  REQUIRE(hi >= interval.hi);
}

void require_thin(const SolidTruth& s) {
  require_thin(s.volume.enclosure);
  for (const auto& value : s.first_moments) require_thin(value.enclosure);
  for (const auto& value : s.second_moments) require_thin(value.enclosure);
  for (const Interval& c : s.centroid) require_thin(c);
  for (const Interval& i : s.inertia) require_thin(i);
}

void require_same(const SolidTruth& a, const SolidTruth& b) {
  REQUIRE(same(a.volume, b.volume));
  for (std::size_t i = 0; i < 3; ++i) REQUIRE(same(a.first_moments[i], b.first_moments[i]));
  for (std::size_t k = 0; k < 6; ++k) REQUIRE(same(a.second_moments[k], b.second_moments[k]));
}

TEST_CASE("mass: a box: V = 8 abc, Ixx = V (b² + c²)/3") {
  const SolidTruth s = solid(Box{Vec3(1, 2, 3)});
  CHECK(s.volume.rational == Rational(48));
  CHECK(s.second_moments[0].rational == Rational(208));
  CHECK(s.second_moments[1].rational == Rational(160));
  CHECK(s.second_moments[2].rational == Rational(80));
  for (std::size_t k = 3; k < 6; ++k) CHECK(s.second_moments[k].rational == Rational(0));
  CHECK(s.inertia[0] == Interval{208, 208});
  CHECK(s.centroid[0] == Interval{0, 0});
}

TEST_CASE("mass: a sphere: V = 4/3 π r³, I = 2/5 V r²") {
  const SolidTruth s = solid(Sphere{2});
  CHECK(s.volume.rational == Rational(0));
  CHECK(s.volume.pi_multiple == Rational(std::string("32/3")));
  CHECK(s.volume.enclosure.lo <= 33.510321638291127);
  CHECK(s.volume.enclosure.hi >= 33.510321638291127);
  CHECK(s.second_moments[0].pi_multiple == Rational(std::string("256/15")));
  CHECK(s.second_moments[3].pi_multiple == Rational(0));
  require_thin(s);
}

// Volume 1/6, ∫ x = 1/24, ∫ x² = 1/60, ∫ xy = 1/120 over the corner tetrahedron, by elementary integration.
TEST_CASE("mass: the corner tetrahedron") {
  const SolidTruth s = solid(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  CHECK(s.volume.rational == Rational(std::string("1/6")));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(s.first_moments[i].rational == Rational(std::string("1/24")));
    CHECK(s.second_moments[i].rational == Rational(std::string("1/30")));
    CHECK(s.second_moments[i + 3].rational == Rational(std::string("-1/120")));
    CHECK(s.centroid[i] == Interval{0.25, 0.25});
    CHECK((s.inertia[i].lo <= 0.0125 && 0.0125 <= s.inertia[i].hi));  // 1/30 − 2 (1/6)/16 = 1/80
  }
}

TEST_CASE("mass: a box and the same box as a polytope, anywhere") {
  Dice dice(31);
  for (int i = 0; i < 100; ++i) {
    const double thickness = dice.unit() + 0.5;
    const Vec3 h(dice.between(1, 9), thickness, 2);
    const Vec3 p = 4 * dice.in_cube();
    const Quaternion q = tests::integer_quaternion(dice);
    require_same(solid(Box{h}), solid(cuboid(h)));
    require_same(solid(posed(Box{h}, p, q)), solid(posed(cuboid(h), p, q)));
    require_thin(solid(posed(Box{h}, p, q)));
  }
}

// The fan of tetrahedra from any point of the solid cuts it into parts whose moments add up.
TEST_CASE("mass: moments are additive") {
  Dice dice(32);
  for (int i = 0; i < 100; ++i) {
    const Shape shape = tests::lattice_hull(dice, 12, 4);
    const auto* whole = std::get_if<Polytope>(&shape);
    if (whole == nullptr) continue;
    const Vec3 middle = (whole->vertices[0] + whole->vertices[1] + whole->vertices[2] + whole->vertices[3]) / 4;
    Compound parts;
    for (const std::vector<int>& face : whole->faces) {
      for (std::size_t k = 2; k < face.size(); ++k) {
        const auto at = [&](int v) { return whole->vertices[static_cast<std::size_t>(v)]; };
        try {
          parts.parts.push_back({Pose{}, convex_hull({middle, at(face[0]), at(face[k - 1]), at(face[k])})});
        } catch (const std::exception&) {
          // the four vertices were coplanar and the point is on this face
        }
      }
    }
    require_same(solid(shape), solid(parts));
  }
}

TEST_CASE("mass: a rigid motion: C = R c + p, I about the centroid turns along") {
  Dice dice(33);
  for (int i = 0; i < 50; ++i) {
    const Polytope p = tests::round_hull(dice, 10);
    const SolidTruth at_rest = solid(p);
    // A third of a turn about (1, 1, 1): x → y → z → x. Exact in doubles.
    const SolidTruth turned = solid(posed(p, Vec3(0, 0, 0), {1, 1, 1, 1}));
    REQUIRE(same(turned.volume, at_rest.volume));
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(same(turned.first_moments[(k + 1) % 3], at_rest.first_moments[k]));
      REQUIRE(same(turned.second_moments[(k + 1) % 3], at_rest.second_moments[k]));
    }
    REQUIRE(same(turned.second_moments[5], at_rest.second_moments[3]));  // xy → yz
    REQUIRE(same(turned.second_moments[3], at_rest.second_moments[4]));  // xz → yx
    REQUIRE(same(turned.second_moments[4], at_rest.second_moments[5]));  // yz → zx
    // The trace of the inertia about the centroid is the same in any pose.
    const Vec3 t = 8 * dice.in_cube();
    const SolidTruth moved = solid(posed(p, t, tests::integer_quaternion(dice)));
    REQUIRE(same(moved.volume, at_rest.volume));
    const auto trace = [](const SolidTruth& s) { return s.inertia[0].lo + s.inertia[1].lo + s.inertia[2].lo; };
    REQUIRE(trace(moved) == Approx(trace(at_rest)).epsilon(1e-14));
    // Parallel axes: C' − C = V t for a translation.
    const SolidTruth shifted = solid(posed(p, t));
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(shifted.first_moments[k].rational ==
              at_rest.first_moments[k].rational + at_rest.volume.rational * Rational(t[static_cast<Eigen::Index>(k)]));
      REQUIRE(shifted.inertia[k] == at_rest.inertia[k]);
    }
  }
}

TEST_CASE("mass: the length of a quaternion and its sign do not matter") {
  const Polytope p = cuboid(Vec3(1, 2, 3));
  const SolidTruth s = solid(posed(p, Vec3(1, 2, 3), {1, 2, -3, 1}));
  for (const double f : {-1.0, 0x1p500, 0x1p-500, 3.0})
    require_same(s, solid(posed(p, Vec3(1, 2, 3), {f, 2 * f, -3 * f, f})));
}

TEST_CASE("mass: a power of two scales volume by its cube and inertia by its fifth power") {
  for (const double f : {0x1p100, 0x1p-100}) {
    Dice dice(34);
    const Polytope p = tests::round_hull(dice, 12);
    const SolidTruth a = solid(p);
    const SolidTruth b = solid(tests::stretched(p, Vec3(f, f, f)));
    const Rational s(f);
    CHECK(b.volume.rational == a.volume.rational * s * s * s);
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(b.second_moments[k].rational == a.second_moments[k].rational * s * s * s * s * s);
    }
  }
}

TEST_CASE("mass: beyond the range of doubles an enclosure says so") {
  const SolidTruth huge = solid(Box{Vec3(0x1p500, 0x1p500, 0x1p500)});
  CHECK(huge.volume.enclosure.hi == INFINITY);
  CHECK(huge.centroid[0] == Interval{0, 0});
  const SolidTruth tiny = solid(Box{Vec3(0x1p-500, 0x1p-500, 0x1p-500)});
  CHECK(tiny.volume.enclosure.lo == 0);
  CHECK(tiny.volume.enclosure.hi > 0);
  CHECK(tiny.volume.rational.sign() == 1);
}

TEST_CASE("mass: a compound counts an overlap once a part, and mixes π with rationals") {
  Compound twice;
  twice.parts = {{Pose{}, Sphere{1}}, {Pose{}, Sphere{1}}, {Pose{Vec3(5, 0, 0), {}}, Box{Vec3(1, 1, 1)}}};
  const SolidTruth s = solid(twice);
  CHECK(s.volume.rational == Rational(8));
  CHECK(s.volume.pi_multiple == Rational(std::string("8/3")));
  CHECK(s.first_moments[0].rational == Rational(40));
  // c = 40/(8 + 8π/3)
  CHECK(s.centroid[0].lo == Approx(40 / (8 + 8.3775804095727813)).epsilon(1e-15));
  require_thin(s);
}

TEST_CASE("mass: mass of a scene: density multiplies, given properties pass, a fixed body has none") {
  Scene scene;
  Body heavy = tests::body(Box{Vec3(1, 1, 1)});
  heavy.mass = Density{0.25};
  Body given = tests::body(Sphere{1});
  const MassProperties properties{3, Vec3(1, 0, 0), Vec3(2, 3, 4).asDiagonal()};
  given.mass = properties;
  Body wall = tests::body(Sphere{1});
  wall.mass = Fixed{};
  scene.bodies = {heavy, given, wall};
  const auto masses = mass(scene);
  REQUIRE(masses.size() == 3);
  CHECK(masses[0]->mass == Interval{2, 2});
  CHECK(masses[0]->I_BBcm_B[0].lo <= 4.0 / 3);
  CHECK(masses[0]->I_BBcm_B[0].hi >= 4.0 / 3);
  CHECK(masses[1]->mass == Interval{3, 3});
  CHECK(masses[1]->p_BBcm[0] == Interval{1, 1});
  CHECK(masses[1]->I_BBcm_B[2] == Interval{4, 4});
  CHECK_FALSE(masses[2].has_value());
}

}  // namespace
}  // namespace touchstone::reference
