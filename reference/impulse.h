// The exact truth about one impact: Poisson, Stronge or Newton restitution with Coulomb friction at one point.
//
// Routh's hypothesis: poses do not change during the impact. Velocities change with the impulse P on A at C (B takes
// −P): u = u0 + K P, where u is the velocity of A's point at C relative to B's and, with r = C − centre of mass,
//   K = Σ over moved bodies of (1/m) 1 − [r]× I⁻¹ [r]×      (symmetric, positive definite).
// The normal impulse p = P·n̂ grows from 0. While the slip u_t ≠ 0: dP_t/dp = −μ u_t/|u_t|. At slip 0: dP_t/dp is the t
// in the disc |t| ≤ μ for which (t, 1)ᵀ K (t, 1) is least; inside the disc the contact sticks, else it slips along −t
// from then on. Compression ends at p_c, the first u_n = 0; the restitution law gives the p_f at which restitution
// ends. With Poisson's law u_n < 0 is possible at the end: then a new compression starts from there
// (docs/design/impulse.md derives all of this).
#pragma once

#include <array>
#include <optional>

#include "model/scene.h"
#include "reference/rational.h"

namespace touchstone::reference {

using ExactVec3 = std::array<Rational, 3>;

/// Of the centre of mass, and angular; in W.
struct ExactVelocity {
  ExactVec3 v_WBcm;  ///< m/s
  ExactVec3 w_WB;    ///< rad/s
};

/// The impulse, the velocities after it, and what happened in between.
struct ImpulseTruth {
  /// What happened. Slip whose direction turns smoothly is neither `straight` nor `stuck_from_start`.
  struct Modes {
    bool separating = false;    ///< u_n ≥ 0 before: no impulse
    bool frictionless = false;  ///< μ = 0
    bool stuck_from_start = false;
    bool straight = false;  ///< slips along the line of u_t until slip stops
    bool slip_stops_in_compression = false;
    bool slip_stops_in_restitution = false;
    bool sticks = false;        ///< after slip has stopped, or from the start
    bool reversal = false;      ///< slips again along the line of u_t, in the opposite direction
    bool diverges = false;      ///< slips again in any direction, reversal included
    bool recompressed = false;  ///< Poisson: restitution ended with u_n < 0
    bool painleve = false;      ///< μ |K_tn| > K_nn: u_n may fall while p grows

    bool operator==(const Modes&) const = default;
  };

  std::array<ExactVec3, 3> K_W;        ///< rows, in W's axes (1/kg); exact, but see `pi`
  ExactVec3 u0_W;                      ///< velocity of A's point at C relative to B's, before (m/s); exact
  ExactVec3 P_A_W;                     ///< on A at C (N s)
  Rational p_c, p_f;                   ///< normal impulse at the end of the first compression, and at the end (N s)
  std::array<ExactVelocity, 2> after;  ///< velocities of bodies 0 (A) and 1 (B) after P_A_W, exactly
  Modes modes;

  /// Bound of the error of P_A_W, as sqrt(dPᵀ K dP) (sqrt(J)); 0 if P_A_W is exact.
  double error = 0;
  bool certified = false;  ///< `error` is proved: P_A_W is exact or the middle of an enclosure. Else it is an estimate
  bool pi = false;         ///< a sphere's mass contains π, which is replaced by a rational within 2^-319 of it

  /// Set if the law itself is discontinuous near this scene: how near, as the missing u_n over sqrt(K_nn u0ᵀ K⁻¹ u0),
  /// at most 1e-9.
  std::optional<double> ambiguous;

  /// How flat u_n(p) is where a compression ends, or Newton's restitution: the least du_n/dp over K_nn; 1 where μ
  /// |K_tn| ≤ K_nn. An error of u_n moves p by the error over du_n/dp.
  double flattest = 1;
};

/// The precision asked for where P is not exact.
enum class Digits {
  some,  ///< 22 digits (2^-75 of the energy norm), enough to judge doubles; `many` if K is too near singular
  many,  ///< 45 digits
};

/// Requires a completed scene (reference/validity.h). Throws InputError if there is no contact, or if an inertia is
/// positive definite within rounding but not exactly.
/// Cost: 0.1 ms where P is exact; else 0.5 ms for some digits, 10 ms for many.
ImpulseTruth impulse(const Scene& scene, Digits digits = Digits::many);

}  // namespace touchstone::reference
