// How much wider than the exact box fast's box may be (fast/bounds.h).
#pragma once

#include <algorithm>
#include <variant>

#include "model/scene.h"
#include "reference/rational.h"

namespace touchstone::tests {

inline double reach(const Sphere& sphere) { return sphere.radius; }
inline double reach(const Box& box) { return box.half_extents.lpNorm<1>(); }
inline double reach(const Polytope& polytope) {
  double greatest = 0;
  for (const Vec3& v : polytope.vertices) greatest = std::max(greatest, v.lpNorm<1>());
  return greatest;
}
inline double reach(const Compound& compound) {
  double greatest = 0;
  for (const Part& part : compound.parts) {
    const double own = std::visit([](const auto& shape) { return reach(shape); }, part.shape);
    greatest = std::max(greatest, 2 * (own + part.X_BP.p_WB.lpNorm<1>()));
  }
  return greatest;
}

/// 2E of fast/bounds.h as a rational (a double's sum could overflow); 1 part in 2^40 more for the sums above.
inline reference::Rational widening(const Body& b) {
  const double size = std::visit([](const auto& shape) { return reach(shape); }, b.shape);
  const double parts = std::holds_alternative<Compound>(b.shape) ? 2 : 1;
  using reference::Rational;
  return Rational(0x1p-48 * (1 + 0x1p-40)) *
             (Rational(size) + Rational(parts * b.X_WB.p_WB.lpNorm<Eigen::Infinity>())) +
         Rational(0x1p-1058);
}

}  // namespace touchstone::tests
