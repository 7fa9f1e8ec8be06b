// One impact at one point, in its own axes.
#pragma once

#include "model/scene.h"

namespace touchstone::fast::impulse {

/// A's point moves relative to B's with u; an impulse P on A changes u by K P. Axes 1, 2: tangents along which K's
/// tangential block A = diag(l1, l2); axis n: the normal, from B to A.
///
///   K = [l1  0 k1;  0 l2 k2;  k1 k2 b], positive definite (1/kg); u in m/s, P in N s.
struct Impact {
  double l1 = 1, l2 = 1, k1 = 0, k2 = 0, b = 1;
  double u1 = 0, u2 = 0, un = 0;
  Law law = Law::poisson;
  double e = 0;   ///< in [0, 1]
  double mu = 0;  ///< ≥ 0; infinity: sticks
};

/// The state of an impact in progress: P so far, and the slip.
///
/// Slip u_t = s·(c, d), |(c, d)| = 1. It is integrated rather than computed from P, so that a slip of 1e-300 beside a
/// normal speed of 1 still has its direction.
struct ImpactState {
  double s = 0, c = 1, d = 0;
  double P1 = 0, P2 = 0, p = 0;  ///< p: normal
  double work = 0;               ///< ∫ u_n dp, J
};

inline double normal_speed(const Impact& impact, const ImpactState& at) {
  return impact.un + (impact.k1 * at.P1 + impact.k2 * at.P2 + impact.b * at.p);
}

/// Where a compression or restitution ends: the quantity reaches the value from below.
struct Goal {
  enum class Of { speed, impulse, work };
  Of of = Of::speed;
  double value = 0;
};

/// Rates per unit of normal impulse while the direction of slip is constant, or there is no slip.
struct Line {
  double t1 = 0, t2 = 0;  ///< of P1, P2
  double h = 1;           ///< of u_n: K_nn + k·t
  double g = 0;           ///< of s
};

/// Slip along (c, d): t = −mu (c, d).
inline Line sliding(const Impact& i, double c, double d) {
  const double t1 = -i.mu * c, t2 = -i.mu * d;
  return {t1, t2, i.b + (i.k1 * t1 + i.k2 * t2), c * (i.k1 + i.l1 * t1) + d * (i.k2 + i.l2 * t2)};
}

}  // namespace touchstone::fast::impulse
