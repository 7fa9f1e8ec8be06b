// One impact in exact numbers, in W's axes. The normal is used as given, N = n and not n/|n|, so that nothing
// irrational appears.
//
// With ν = |N|, P = p N + P_t and U = u·N: p here is the normal impulse over ν, U is ν u_n, and the cone is |P_t| ≤ μ ν
// p.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>

#include "model/scene.h"
#include "reference/motion/plain_pose.h"

namespace touchstone::reference {

/// A body's response to an impulse at C; all 0 if the body is fixed.
struct Response {
  mpq_class inverse_mass;
  std::array<Triple, 3> inverse_inertia;  ///< about the centre of mass, W's axes
  Triple arm;                             ///< from the centre of mass to C

  /// The changes of velocity by an impulse P at C.
  Triple linear(const Triple& P) const;
  Triple angular(const Triple& P) const;
};

struct Impact {
  std::array<Response, 2> bodies;
  std::array<Triple, 3> K;
  Triple u0;
  Triple N;
  Law law = Law::poisson;
  mpq_class e;
  std::optional<mpq_class> mu;  ///< none: infinite
  bool pi = false;              ///< a rational replaces π
};

/// Throws InputError: see reference/impulse.h.
Impact impact(const Scene& scene);

}  // namespace touchstone::reference
