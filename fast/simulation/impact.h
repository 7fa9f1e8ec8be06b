// What an impact does to two bodies on their paths.
#pragma once

#include "fast/simulation/meeting.h"

namespace touchstone::fast::world {

/// Coefficients of a pair: the least of the two bodies' (docs/design/simulation.md).
struct Coefficients {
  double restitution = 0, friction = 0;
  Law law = Law::poisson;
};

Coefficients coefficients(const Mover& a, const Mover& b, Law law);

/// What was met, and what came of it.
struct Hit {
  double u_n = 0;  ///< m/s; normal velocity of A's point against B's, before: < 0 approaches
  Vec3 P_A_W = Vec3::Zero();
  Velocity after_a, after_b;
  double loss = 0;  ///< J; kinetic energy that is gone
};

/// Normal velocity of A's point at C against B's.
double approach(const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Touch& touch);

/// The impulse at the touch, of bodies in the given states. Balls and what is fixed: a closed form, since K's normal
/// does not mix with its tangents (all laws agree): p = (1 + e) |u_n| / K_nn, P_t = min(mu p, s / K_tt) against the
/// slip s. Else fast/impulse.h.
Hit impact(const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Touch& touch,
           const Coefficients& coefficients);

/// One of many hops that stand for a resting contact: parts with u_n = `speed`. As fast/impulse/micro_collision.h, with
/// u_n' = (u_n − speed)/2 in place of u_n: if P = −2 K⁻¹u' is in the friction cone, it: slip turns round, so that it is
/// 0 in the mean; else what an elastic impact against u' does. Of second order in `speed`; the first of a row, with u_n
/// = 0, is the half kick that makes it so (docs/design/simulation.md).
Hit micro_collision(const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Touch& touch,
                    Coefficients coefficients, double speed);

}  // namespace touchstone::fast::world
