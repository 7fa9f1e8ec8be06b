// The mass properties of a body that is not fixed, as plain rationals.
#pragma once

#include <gmpxx.h>

#include <array>
#include <string>

#include "model/scene.h"
#include "reference/motion_impl.h"

namespace touchstone::reference {

/// Mass, centre of mass and inertia about it in B's axes. A sphere's hold π: a rational within 2^-319 of it stands for
/// it.
struct Heavy {
  mpq_class mass;
  Triple centre;
  std::array<Triple, 3> inertia;
  bool pi = false;
};

/// `place` names the body in messages. Requires a body that is not fixed; throws InputError if a given inertia is
/// positive definite within rounding, but not exactly.
Heavy heavy(const Body& body, const std::string& place);

}  // namespace touchstone::reference
