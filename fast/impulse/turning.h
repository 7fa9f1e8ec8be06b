// How slip changes its direction and magnitude, relative to one direction.
#pragma once

#include <array>

#include "fast/impulse/impact.h"

namespace touchstone::fast::impulse {

/// With θ the direction of slip, s dθ/dp = η(θ) and ds/dp = g(θ).
///
/// Axes along and across the direction (c, d): in these k is (k1, k2) and A is [alpha beta; beta gamma]. With t =
/// tan((θ − direction)/2), η (1 + t²)² and g (1 + t²)² are polynomials of degree 4 in t.
struct Turning {
  double k1, k2, alpha, beta, gamma;
  std::array<double, 5> eta, g;
};

inline Turning turning(const Impact& i, double c, double d) {
  Turning x{};
  x.k1 = i.k1 * c + i.k2 * d;
  x.k2 = i.k2 * c - i.k1 * d;
  x.alpha = i.l1 * c * c + i.l2 * d * d;
  x.beta = (i.l2 - i.l1) * c * d;
  x.gamma = i.l1 * d * d + i.l2 * c * c;
  const double spread = i.mu * (x.alpha - x.gamma), mu_beta = i.mu * x.beta;
  x.eta = {x.k2 - mu_beta, 2 * (spread - x.k1), 6 * mu_beta, -2 * (spread + x.k1), -x.k2 - mu_beta};
  x.g = {x.k1 - i.mu * x.alpha, 2 * x.k2 - 4 * mu_beta, i.mu * (2 * x.alpha - 4 * x.gamma), 2 * x.k2 + 4 * mu_beta,
         -x.k1 - i.mu * x.alpha};
  return x;
}

/// The magnitude of the rates of s and θ in dp/s.
inline double rate(const Impact& i) {
  return (i.k1 < 0 ? -i.k1 : i.k1) + (i.k2 < 0 ? -i.k2 : i.k2) + i.mu * (i.l1 > i.l2 ? i.l1 : i.l2);
}

}  // namespace touchstone::fast::impulse
