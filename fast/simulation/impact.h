// The impulse and the velocities after an impact of two bodies on their trajectories.
#pragma once

#include "fast/simulation/prediction/pair_time_of_impact.h"

namespace touchstone::fast::simulation {

/// Coefficients of a pair: the lesser of the two bodies' values (docs/design/simulation.md).
struct Coefficients {
  double restitution = 0, friction = 0;
  Law law = Law::poisson;
};

Coefficients coefficients(const BodyMotion& a, const BodyMotion& b, Law law);

/// An impact: the approach before it, its impulse, and the velocities after it.
struct ImpactResult {
  double u_n = 0;  ///< m/s; velocity of A's point relative to B's along n̂, before the impact; < 0: they approach
  Vec3 P_A_W = Vec3::Zero();
  Velocity after_a, after_b;
  double loss = 0;  ///< J; loss of kinetic energy
};

/// The velocity of A's point at C relative to B's (m/s).
Vec3 relative_velocity(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                       const Vec3& p_WC);

/// The same along n̂, at a touch.
double normal_velocity(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                       const Touch& touch);

/// The impact at the touch of two bodies in the given states. Two balls, or a ball and a fixed body, have a closed
/// form, since K does not couple the normal with the tangents (all laws agree): p = (1 + e) |u_n| / K_nn and, against
/// the slip s, P_t = min(mu p, s / K_tt). Other bodies: fast/impulse.h.
ImpactResult impact(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b, const Touch& touch,
                    const Coefficients& coefficients);

/// The velocities after an impulse P on A at the touch, and −P on B.
ImpactResult impulse_at(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                        const Touch& touch, const Vec3& P);

/// One of the many micro-bounces that replace a resting contact: the bodies separate with u_n = `speed`. With
/// u_n' = (u_n − speed)/2 in place of u_n: if P = −2 K⁻¹u' is in the friction cone, the impulse is P, which reverses
/// the slip, so that its mean is 0 (only the factor 2 conserves the energy); otherwise it is that of an elastic impact
/// against u'. The error is of second order in `speed`; the first of a series, with u_n = 0, is the half kick that
/// makes it so. Source: Mirtich 1996, 3.5; docs/design/simulation.md.
ImpactResult micro_collision(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                             const Touch& touch, Coefficients coefficients, double speed);

}  // namespace touchstone::fast::simulation
