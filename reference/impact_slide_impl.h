// An impact's course while the direction of slip turns, in 76 digits.
//
// In axes in which K's tangential block is diag(l1, l2), with slip s (x, y), x² + y² = 1, and dp = s dτ, the equations
// are polynomial and regular even at s = 0 (which is τ = ∞):
//   x' = −h y   y' = h x   s' = g s   p' = s   D' = s²
//   h = k2 x − k1 y + μ (l1 − l2) x y      g = k1 x + k2 y − μ (l2 + (l1 − l2) x²)
// They are solved by their Taylor series in τ. All else follows: K's rows give P from s (x, y) and p, and
// T − T0 = W − μ D gives W.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "reference/float_impl.h"
#include "reference/impact_law_impl.h"

namespace touchstone::reference {

/// Requires |N| = 1: Float has no use for another.
struct Tangent {
  explicit Tangent(const Blow<Float>& blow);

  Three<Float> e1, e2, n;
  Float l1, l2, k1, k2, b, mu;

  /// dU/dp and its change with τ.
  Float rise(const Float& x, const Float& y) const { return b - mu * (k1 * x + k2 * y); }
  Float h(const Float& x, const Float& y) const { return k2 * x - k1 * y + mu * (l1 - l2) * x * y; }
  Float g(const Float& x, const Float& y) const { return k1 * x + k2 * y - mu * (l2 + (l1 - l2) * x * x); }
};

/// The tangential direction, of length μ, in which slip leaves 0 if it does not stick.
Three<Float> diverging(const Blow<Float>& blow, const Three<Float>& sticking);

struct Slip {
  Float x, y, s, p, D;
};

class Slide {
 public:
  explicit Slide(const Blow<Float>& blow);

  const std::optional<Float>& stopped() const { return stopped_; }
  std::unique_ptr<Stretch<Float>> next(const Walk<Float>& walk);

 private:
  const Blow<Float>& blow_;
  Tangent tangent_;
  Slip first_;
  Slip now_;
  Float negligible_;  ///< slip so slow that the law at 0 gives the same impulse, to 2^-200 in the energy norm
  std::vector<std::unique_ptr<Stretch<Float>>> pieces_;  ///< of the last series, the next one last
  std::optional<Slip> stop_;                             ///< where slip will stop, once that can be told
  bool settled_ = false;                                 ///< slip turns no more, to the last bit kept
  std::optional<Float> stopped_;

  Moment<Float> moment(const Slip& slip) const;
  void foresee();
  std::unique_ptr<Stretch<Float>> straight();
  std::unique_ptr<Stretch<Float>> jump(const Walk<Float>& walk);
  void step();

  friend class Piece;
};

}  // namespace touchstone::reference
