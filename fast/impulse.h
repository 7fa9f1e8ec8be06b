// The impulse at a scene's contact, in doubles.
#pragma once

#include "fast/impulse/solve.h"
#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// The result of an impact, with diagnostics computed from the result alone.
struct Impacted {
  Vec3 P_A_W = Vec3::Zero();  ///< N s, on A at C; B takes exactly its opposite
  std::array<Velocity, 2> after;
  impulse::Outcome outcome;
  double error = 0;          ///< bound of |P − P*|_K, sqrt(J); empirical, see fast/impulse/solve.h
  double cone_excess = 0;    ///< |P_t| − mu P_n, N s: ≤ rounding
  double energy_change = 0;  ///< (u_0 + u_f)·P/2, J: ≤ 0 except for Newton's law
};

/// Requires a valid scene with a contact (model/limits.h). Throws InputError if it has none.
///
/// K = Σ 1/m − [r]× I⁻¹ [r]×, r from the centre of mass to C; u = the velocity of A's point at C relative to B's.
Impacted impact(const Scene& scene);

/// The same as a query's answer. `ambiguous`: the law itself is discontinuous within that relative distance of the
/// scene (1e-9 or less).
Impulse impulse_of(const Scene& scene);

}  // namespace touchstone::fast
