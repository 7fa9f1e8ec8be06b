// An impact from approach to the end of restitution, by the law of the contact.
#pragma once

#include "fast/impulse/impact.h"

namespace touchstone::fast::impulse {

/// What happened during the impact.
struct Regime {
  bool approached = false;  ///< otherwise nothing happens
  bool curved = false;      ///< the direction of slip changed: the general solver was needed
  bool stopped = false;     ///< slip stopped, or there was none
  bool slid_off = false;    ///< it stopped and then started again
  bool compressed_again = false;
};

struct Outcome {
  double P1 = 0, P2 = 0, p = 0;  ///< N s, on A
  double compression = 0;        ///< p at the end of the (first) compression
  Regime regime;

  /// Distance from a discontinuity of the law itself, relative to |u|: how far u_n stayed from becoming 0 in the other
  /// way.
  double miss = 1;

  /// At most 1: the least slope du_n/dp, over K_nn, at which u_n reached its goal, where slip can press the bodies
  /// together. An error of u_n moves p by the error over the slope.
  double flattest = 1;
};

/// The impulse of one impact.
///
/// Compression until u_n = 0; restitution until p = (1 + e) p_c (Poisson), W_n = (1 − e²) W_c (Stronge) or u_n = −e
/// u_n0 (Newton). Slip obeys dP_t/dp = −mu u_t/|u_t|. If the bodies still approach when restitution ends, which is
/// possible only for mu |k| > K_nn, a new compression follows. mu = infinity sticks from the start: P_t = −A⁻¹ u_t at p
/// = 0.
///
/// Error: |P − P*|_K ≤ error_bound (below), relative to |u|_{K⁻¹}, or to |P|_K/2 if that is more (only Newton's law can
/// add energy), over `flattest`; measured, not proved (docs/design/impulse.md). Source: Routh 1860; Mirtich 1996, 3;
/// docs/design/impulse.md for the form.
Outcome solve(const Impact& impact);

/// 256·2⁻⁵³ for cond(K) ≤ 10, 1024·2⁻⁵³ cond(K) beyond.
double error_bound(double condition);

}  // namespace touchstone::fast::impulse
