// What `balance` says stands or falls, on both sides of limits that statics gives, proved in exact numbers: its forces,
// made exact, balance the loads within the cones; or what it leaves of the loads is a motion that nothing hinders.
#include <algorithm>
#include <cmath>

#include "fast/contact/sparse/balance.h"
#include "reference/equilibrium.h"
#include "tests/catch.h"
#include "tests/fast/contact/sparse/cubes.h"

namespace touchstone::fast::contact {
namespace {

using reference::ExactVec3;
using reference::ExactVelocity;
using reference::LoadedBodies;

constexpr double g = 10;

/// Loads in N, of bodies of mass 1 that do not rotate.
LoadedBodies loaded(const Contacts& contacts) {
  LoadedBodies bodies;
  for (std::size_t i = 0; i < contacts.bodies.size(); ++i) {
    auto& load = bodies.loads.emplace_back();
    if (contacts.bodies[i].inverse_mass > 0) load = LoadedBodies::Load{contacts.twists[i].v, Vec3::Zero()};
  }
  for (const ContactRow& row : contacts.rows)
    bodies.points.push_back({row.a, row.b, row.n, row.arm_A, row.arm_B, row.friction});
  return bodies;
}

/// A motion in which all contacts open more than they slip.
using Lift = std::vector<Twist>;

ExactVec3 sum(const Vec3& a, double part, const Vec3& b) {
  using reference::Rational;
  return {Rational(a.x()) + Rational(part) * b.x(), Rational(a.y()) + Rational(part) * b.y(),
          Rational(a.z()) + Rational(part) * b.z()};
}

enum class Verdict { stands, falls, open };

/// The proof of either answer. A point on its cone's surface has no room for the correction that makes balance exact,
/// so its friction is reduced a little; d misses the dual cones by rounding, which a little of the lift makes up for.
Verdict proved(Contacts contacts, const Lift& lift) {
  const LoadedBodies bodies = loaded(contacts);
  const auto motion = balance(contacts.rows, contacts.bodies, contacts.twists);
  std::vector<Vec3> P;
  for (const ContactRow& row : contacts.rows) P.push_back(row.P);
  bool stands = false;
  for (double inwards = 0x1p-40; inwards < 0x1p-18 && !stands; inwards *= 0x1p10) {
    const auto exact = reference::balanced(bodies, P, inwards);
    stands = exact && proves_standing(bodies, *exact);
  }
  bool falls = false;
  if (motion) {
    const double greatest = greatest_speed(*motion);
    for (double part = 0x1p-50; part < 0x1p-15 && !falls; part *= 2) {
      std::vector<ExactVelocity> opening;
      for (std::size_t i = 0; i < motion->size(); ++i) {
        const Twist& d = (*motion)[i];
        opening.push_back({sum(d.v, part * greatest, lift[i].v), sum(d.w, part * greatest, lift[i].w)});
      }
      falls = proves_falling(bodies, opening);
    }
  }
  REQUIRE_FALSE((stands && falls));
  return stands ? Verdict::stands : falls ? Verdict::falls : Verdict::open;
}

/// Each cube is raised in proportion to its level.
Lift raised(std::size_t count) {
  Lift lift;
  for (std::size_t i = 0; i < count; ++i) lift.push_back({Vec3(0, 0, static_cast<double>(i + 1)), Vec3::Zero()});
  lift.emplace_back();
  return lift;
}

Verdict stack(int count, double step, double slope) {
  return proved(leaning_stack(count, step, g * Vec3(slope, 0, -1), 0.5), raised(index(count)));
}

// The limits are those of balance_test.cpp.
TEST_CASE("certificate: a leaning stack of n cubes, up to a step of 1/n") {
  CHECK(stack(3, 0.3333, 0) == Verdict::stands);
  CHECK(stack(3, 0.3334, 0) == Verdict::falls);
  CHECK(stack(10, 0.0999, 0) == Verdict::stands);
  CHECK(stack(10, 0.1001, 0) == Verdict::falls);
}

TEST_CASE("certificate: a cube on a ramp, up to tan = mu") {
  CHECK(stack(1, 0, 0.499999) == Verdict::stands);
  CHECK(stack(1, 0, 0.500001) == Verdict::falls);
}

TEST_CASE("certificate: a stack of 50 under a tilted pull, up to a slope of 1/50") {
  CHECK(stack(50, 0, 0.0196) == Verdict::stands);
  CHECK(stack(50, 0, 0.0204) == Verdict::falls);
}

/// A half circle of `count` equal stones between the ground's two ends, in the xz-plane. Neighbours touch at the four
/// corners of their seam. The ground is the last body.
struct Arch {
  Contacts contacts;
  Lift lift;

  Arch(int count, double radius, double thickness, double friction) {
    const double pi = 4 * std::atan(1.0), half = pi / (2 * count);
    const double outer = radius + thickness / 2, inner = radius - thickness / 2;
    // The centre of mass of a sector of a ring.
    const double centre =
        2.0 / 3 * std::sin(half) / half * (std::pow(outer, 3) - std::pow(inner, 3)) / (outer * outer - inner * inner);
    const auto radial = [](double angle) { return Vec3(-std::cos(angle), 0, std::sin(angle)); };
    for (int i = 0; i < count; ++i) {
      contacts.bodies.push_back({1, Mat3::Identity()});
      contacts.twists.push_back({Vec3(0, 0, -g), Vec3::Zero()});
    }
    contacts.bodies.emplace_back();
    contacts.twists.emplace_back();
    lift.resize(index(count) + 1);
    // All are raised by so much that the last seam opens too, and each moves on from the one before.
    Vec3 moved(0, 0, 8 * radius);
    for (int seam = 0; seam <= count; ++seam) {
      const double angle = 2 * half * seam;
      const Vec3 n(std::sin(angle), 0, std::cos(angle));  // onwards
      const int before = seam == 0 ? count : seam - 1;
      if (seam < count) lift[index(seam)].v = moved += 2 * half * radius * n;
      for (const double r : {inner, outer}) {
        for (const double y : {-0.5, 0.5}) {
          const Vec3 corner = r * radial(angle) + Vec3(0, y, 0);
          ContactRow row;
          row.a = seam < count ? seam : before;
          row.b = seam < count ? before : count;
          row.n = seam < count ? n : Vec3(-n);
          row.arm_A = corner - centre * radial((2 * row.a + 1) * half);
          row.arm_B = row.b == count ? Vec3(Vec3::Zero()) : Vec3(corner - centre * radial((2 * row.b + 1) * half));
          row.friction = friction;
          prepare(row, contacts.bodies);
          contacts.rows.push_back(row);
        }
      }
    }
  }
};

Verdict arch(double thickness, double friction) {
  const Arch all(16, 4, thickness, friction);
  return proved(all.contacts, all.lift);
}

// Milankovitch 1907: a half circle needs a thickness of 0.1075 of its radius, if it does not slip.
TEST_CASE("certificate: an arch of 16 stones") {
  CHECK(arch(0.4, 1) == Verdict::falls);
  CHECK(arch(0.5, 1) == Verdict::stands);
  CHECK(arch(1, 0.1) == Verdict::falls);
}

TEST_CASE("certificate: neither proof is accepted if it is changed") {
  Contacts contacts = leaning_stack(2, 0.25, Vec3(0, 0, -g), 0.5);
  const LoadedBodies bodies = loaded(contacts);
  balance(contacts.rows, contacts.bodies, contacts.twists);
  std::vector<Vec3> P;
  for (const ContactRow& row : contacts.rows) P.push_back(row.P);
  const std::vector<ExactVec3> exact = reference::balanced(bodies, P, 0x1p-40).value();
  REQUIRE(proves_standing(bodies, exact));
  for (std::size_t k = 0; k < exact.size(); ++k) {
    std::vector<ExactVec3> changed = exact;
    changed[k][2] += 0x1p-60;
    CHECK_FALSE(proves_standing(bodies, changed));
  }
  LoadedBodies slippery = bodies;  // no force balances a pull along x without friction
  for (LoadedBodies::Point& point : slippery.points) point.friction = 0;
  for (std::size_t i : {0, 1}) slippery.loads[i]->force_W.x() = 1;
  const auto sliding = [](double v, double rising) {
    const ExactVelocity along{{v, 0.0, rising}, {0.0, 0.0, 0.0}};
    return std::vector<ExactVelocity>{along, along, along};
  };
  CHECK(proves_falling(slippery, sliding(1, 0)));
  CHECK_FALSE(proves_falling(slippery, sliding(-1, 0)));        // the loads do no work
  CHECK_FALSE(proves_falling(slippery, sliding(1, -0x1p-60)));  // it approaches
  CHECK_FALSE(proves_falling(bodies, sliding(1, 0)));           // nothing pulls along x
  CHECK(proves_falling(slippery, sliding(1, 0x1p-60)));
  slippery.points[0].friction = 0x1p-20;
  CHECK_FALSE(proves_falling(slippery, sliding(1, 0)));  // friction there does work
}

}  // namespace
}  // namespace touchstone::fast::contact
