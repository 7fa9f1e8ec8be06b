// Forces that balance a load exactly: corrections of a solver's forces that statics gives by hand.
#include "reference/equilibrium.h"

#include "tests/catch.h"

namespace touchstone::reference {
namespace {

/// A block of half extents 1 on the ground, which is the last body, by the four corners of a face.
LoadedBodies block_on_ground(const Vec3& force, const Vec3& torque) {
  LoadedBodies bodies;
  bodies.loads = {LoadedBodies::Load{force, torque}, std::nullopt};
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) bodies.points.push_back({0, 1, {0, 0, 1}, {x, y, -1}, {x, y, 0}, 1});
  }
  return bodies;
}

const std::vector<Vec3> quarters(4, Vec3(0, 0, 4));  // of a weight of 16 N

// All four points are equally far from their cones. So the correction of each is z_v + z_ω × arm, times one weight. For
// a torque T about the normal that is T/8 times z × arm, since each arm is √2 long across the normal. For a force F
// along the face at the centre of mass the corners take F/4 each, and the torque that these have about it is taken by
// the normal forces: F at the height 1, by 4 corners at 1.
TEST_CASE("balanced: a torque about the normal is taken by friction, evenly") {
  const LoadedBodies bodies = block_on_ground({0, 0, -16}, {0, 0, 8});
  const auto forces = balanced(bodies, quarters, 0);
  REQUIRE(forces);
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3& arm = bodies.points[k].arm_A_W;
    CHECK((*forces)[k] == ExactVec3{Rational(arm.y()), Rational(-arm.x()), Rational(4)});
  }
  CHECK(proves_standing(bodies, *forces));
}

TEST_CASE("balanced: a force along the face is taken by friction, and tips the normal forces") {
  for (const std::size_t along : {std::size_t{0}, std::size_t{1}}) {
    Vec3 force(0, 0, -16);
    force[static_cast<Eigen::Index>(along)] = -4;
    const LoadedBodies bodies = block_on_ground(force, Vec3::Zero());
    const auto forces = balanced(bodies, quarters, 0);
    REQUIRE(forces);
    for (std::size_t k = 0; k < 4; ++k) {
      ExactVec3 expected{Rational(0), Rational(0),
                         Rational(4 - bodies.points[k].arm_A_W[static_cast<Eigen::Index>(along)])};
      expected[along] = Rational(1);
      CHECK((*forces)[k] == expected);
    }
    CHECK(proves_standing(bodies, *forces));
  }
}

TEST_CASE("balanced: three points that do not span all directions hold nothing, nor do points outside their cones") {
  LoadedBodies bodies = block_on_ground({0, 0, -16}, {0, 0, 8});
  CHECK_FALSE(balanced(bodies, std::vector<Vec3>(4, Vec3(5, 0, 4)), 0));  // μ = 1
  CHECK(balanced(bodies, std::vector<Vec3>(4, Vec3(5, 0, 4)), 0.5));      // with half the friction they are inside
  bodies.points.resize(2);  // two points leave the rotation about the line between them free
  CHECK_FALSE(balanced(bodies, {quarters[0], quarters[1]}, 0));
}

}  // namespace
}  // namespace touchstone::reference
