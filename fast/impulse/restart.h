// What happens once slip has stopped: the contact sticks, or slips in the one direction in which slip can start.
#pragma once

#include "fast/impulse/impact.h"

namespace touchstone::fast::impulse {

struct Restart {
  Line line;
  bool sticks = true;
  double c = 1, d = 0;  ///< direction of slip if it does not stick
};

/// The impulse per unit of normal impulse is (t, 1) with t the minimiser of F(t) = (t, 1)ᵀ K (t, 1) over |t| ≤ mu.
///
/// Inside: t = −A⁻¹k, slip stays 0. On the rim: t = −(A + λ)⁻¹k with |t| = mu, λ > 0, by Newton's method on 1/|t|,
/// which increases to the root from λ = 0 without overshooting; F is strictly convex, so there is one such t. line.h =
/// F(t) + … is ≥ the minimum > 0: the normal speed increases from here on. Source: docs/design/impulse.md.
Restart restart(const Impact& impact);

}  // namespace touchstone::fast::impulse
