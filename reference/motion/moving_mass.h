// The mass properties of a body that is not fixed, as plain rationals.
#pragma once

#include <gmpxx.h>

#include <array>
#include <string>

#include "model/scene.h"
#include "reference/motion/plain_pose.h"

namespace touchstone::reference {

/// Mass, centre of mass and inertia about it in B's axes. For a sphere they contain π, which is replaced by a rational
/// within 2^-319 of it.
struct MovingMass {
  mpq_class mass;
  Triple centre;
  std::array<Triple, 3> inertia;
  bool pi = false;
};

/// `place` names the body in messages. Requires a body that is not fixed. Throws InputError if a given inertia is
/// positive definite within rounding but not exactly.
MovingMass moving_mass(const Body& body, const std::string& place);

}  // namespace touchstone::reference
