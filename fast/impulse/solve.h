// An impact from approach to the end of restitution, by the law that the contact states.
#pragma once

#include "fast/impulse/impact.h"

namespace touchstone::fast::impulse {

/// What was met on the way.
struct Regime {
  bool approached = false;  ///< else nothing happens
  bool curved = false;      ///< slip turned: the general solver was needed
  bool stopped = false;     ///< slip stopped, or there was none
  bool slid_off = false;    ///< and did not stick
  bool compressed_again = false;
};

struct Outcome {
  double P1 = 0, P2 = 0, p = 0;  ///< N s, on A
  double compression = 0;        ///< p at the end of the (first) compression
  Regime regime;

  /// Distance from where the law itself jumps, relative to |u|: how far u_n stayed from turning 0 the other way.
  double miss = 1;
};

/// The impulse of one impact.
///
/// Compression until u_n = 0; restitution until p = (1 + e) p_c (Poisson), W_n = (1 − e²) W_c (Stronge) or
/// u_n = −e u_n0 (Newton). Slip obeys dP_t/dp = −mu u_t/|u_t|. Where restitution ends still approaching, which takes
/// mu |k| > K_nn, a new compression follows. mu = infinity sticks from the start: P_t = −A⁻¹ u_t at p = 0.
///
/// Error: |P − P*|_K ≤ error_bound (below), relative to |u|_{K⁻¹}, or to |P|_K/2 where that is more (Newton's law
/// alone can gain energy); measured, not proved (docs/design/impulse.md).
/// Source: Routh 1860; Mirtich 1996, 3; docs/design/impulse.md for the form.
Outcome solve(const Impact& impact);

/// 256·2⁻⁵³ for cond(K) ≤ 10, 1024·2⁻⁵³ cond(K) beyond.
double error_bound(double condition);

}  // namespace touchstone::fast::impulse
