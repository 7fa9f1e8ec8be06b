// The exact truth about one impact: Poisson, Stronge or Newton restitution with Coulomb friction at one point.
//
// Routh's hypothesis: poses stay, velocities change with the impulse P on A at C (B takes −P), u = u0 + K P, where u is
// the velocity of A's point at C against B's and, with r = C − centre of mass,
//   K = Σ over moved bodies of (1/m) 1 − [r]× I⁻¹ [r]×      (symmetric, positive definite).
// The normal impulse p = P·n̂ grows from 0. While slip u_t ≠ 0: dP_t/dp = −μ u_t/|u_t|. At slip 0: dP_t/dp is the t in
// the disc |t| ≤ μ for which (t, 1)ᵀ K (t, 1) is least; inside the disc the contact sticks, else it slips along −t for
// good. Compression ends at p_c, the first u_n = 0; the law says at which p_f restitution ends. Poisson's rule may end
// with u_n < 0: then a new compression starts from there (docs/design/impulse.md derives all of this).
#pragma once

#include <array>
#include <optional>

#include "model/scene.h"
#include "reference/rational.h"

namespace touchstone::reference {

using ExactVec3 = std::array<Rational, 3>;

struct ExactVelocity {
  ExactVec3 v_WBcm;  ///< m/s
  ExactVec3 w_WB;    ///< rad/s
};

struct ImpulseTruth {
  /// What happened. Slip that turns smoothly is neither `straight` nor `stuck_from_start`.
  struct Modes {
    bool separating = false;    ///< u_n ≥ 0 before: nothing happens
    bool frictionless = false;  ///< μ = 0
    bool stuck_from_start = false;
    bool straight = false;  ///< slips along the line of u_t until slip stops
    bool slip_stops_in_compression = false;
    bool slip_stops_in_restitution = false;
    bool sticks = false;        ///< after slip stopped, or from the start
    bool reversal = false;      ///< slips again along the line of u_t, the other way
    bool diverges = false;      ///< slips again, any way; reversal included
    bool recompressed = false;  ///< Poisson: restitution ended with u_n < 0
    bool painleve = false;      ///< μ |K_tn| > K_nn: u_n may fall while p grows

    bool operator==(const Modes&) const = default;
  };

  std::array<ExactVec3, 3> K_W;        ///< rows, in W's axes (1/kg); exact, but see `pi`
  ExactVec3 u0_W;                      ///< of A's point at C against B's, before (m/s); exact
  ExactVec3 P_A_W;                     ///< on A at C (N s)
  Rational p_c, p_f;                   ///< normal impulse at the end of the first compression, and at the end (N s)
  std::array<ExactVelocity, 2> after;  ///< of bodies 0 (A) and 1 (B): what P_A_W makes of their velocities, exactly
  Modes modes;

  /// sqrt(dPᵀ K dP) of what P_A_W may be off (sqrt(J)); 0 if P_A_W is exact.
  double error = 0;
  bool certified = false;  ///< `error` is proved: P_A_W is exact, or the middle of an enclosure. Otherwise it is stated
  bool pi = false;         ///< a sphere's mass holds π: a rational within 2^-319 of it stands for it everywhere

  /// The law itself jumps near this scene: how near, as the u_n that is missing over sqrt(K_nn u0ᵀ K⁻¹ u0); at most
  /// 1e-9.
  std::optional<double> ambiguous;
};

/// How many digits are asked for where P is not exact.
enum class Digits {
  some,  ///< 22 (2^-75 of the energy norm): what judging doubles needs. As `many` where K is too near singular for that
  many,  ///< 45
};

/// Requires a completed scene (reference/validity.h). Throws InputError without a contact, or if an inertia that is
/// positive definite within rounding is not so exactly.
/// Cost: 0.1 ms where P is exact; else 0.5 ms for some digits, 10 ms for many.
ImpulseTruth impulse(const Scene& scene, Digits digits = Digits::many);

}  // namespace touchstone::reference
