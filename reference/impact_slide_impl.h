// An impact's course while the direction of slip turns. T is Float or DoubleDouble.
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

#include "reference/double_double_impl.h"
#include "reference/float_impl.h"
#include "reference/impact_law_impl.h"

namespace touchstone::reference {

/// Requires |N| = 1: floats have no use for another.
template <class T>
struct Tangent {
  explicit Tangent(const Blow<T>& blow);

  Three<T> e1, e2, n;
  T l1, l2, k1, k2, b, mu;

  /// dU/dp and its change with τ.
  T rise(const T& x, const T& y) const { return b - mu * (k1 * x + k2 * y); }
  T h(const T& x, const T& y) const { return k2 * x - k1 * y + mu * (l1 - l2) * x * y; }
  T g(const T& x, const T& y) const { return k1 * x + k2 * y - mu * (l2 + (l1 - l2) * x * x); }
};

/// The tangential direction, of length μ, in which slip leaves 0 if it does not stick.
template <class T>
Three<T> diverging(const Blow<T>& blow, const Three<T>& sticking);

template <class T>
struct Slip {
  T x, y, s, p, D;
};

template <class T>
class Piece;

template <class T>
class Slide {
 public:
  explicit Slide(const Blow<T>& blow);

  const std::optional<T>& stopped() const { return stopped_; }
  std::unique_ptr<Stretch<T>> next(const Walk<T>& walk);

 private:
  const Blow<T>& blow_;
  Tangent<T> tangent_;
  Slip<T> first_;
  Slip<T> now_;
  T negligible_;  ///< slip so slow that the law at 0 gives the same impulse, to the last bits kept, in the energy norm
  std::vector<std::unique_ptr<Stretch<T>>> pieces_;  ///< of the last series, the next one last
  std::optional<Slip<T>> stop_;                      ///< where slip will stop, once that can be told
  bool settled_ = false;                             ///< slip turns no more, to the last bit kept
  std::optional<T> stopped_;

  Moment<T> moment(const Slip<T>& slip) const;
  void foresee();
  std::unique_ptr<Stretch<T>> straight();
  std::unique_ptr<Stretch<T>> jump(const Walk<T>& walk);
  void step();

  friend class Piece<T>;
};

extern template class Slide<Float>;
extern template class Slide<DoubleDouble>;

}  // namespace touchstone::reference
