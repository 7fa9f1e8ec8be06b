// The phases of an impact while the direction of slip turns. T is Float or DoubleDouble.
//
// In axes in which K's tangential block is diag(l1, l2), with slip s (x, y), x² + y² = 1, and dp = s dτ, the equations
// are polynomial, and regular even at s = 0 (which is τ = ∞):
//   x' = −h y   y' = h x   s' = g s   p' = s   D' = s²
//   h = k2 x − k1 y + μ (l1 − l2) x y      g = k1 x + k2 y − μ (l2 + (l1 − l2) x²)
// They are solved by their Taylor series in τ. The other quantities follow: K's rows give P from s (x, y) and p, and T
// − T0 = W − μ D gives W.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "reference/exact/double_double.h"
#include "reference/exact/float.h"
#include "reference/impulse/law.h"

namespace touchstone::reference {

/// Requires |N| = 1.
template <class T>
struct Tangent {
  explicit Tangent(const ImpactProblem<T>& problem);

  Three<T> e1, e2, n;
  T l1, l2, k1, k2, b, mu;

  /// dU/dp. Its derivative with respect to τ follows from h.
  T rise(const T& x, const T& y) const { return b - mu * (k1 * x + k2 * y); }
  T h(const T& x, const T& y) const { return k2 * x - k1 * y + mu * (l1 - l2) * x * y; }
  T g(const T& x, const T& y) const { return k1 * x + k2 * y - mu * (l2 + (l1 - l2) * x * x); }
};

/// The tangential direction, of length μ, in which slip leaves 0 if the contact does not stick.
template <class T>
Three<T> diverging(const ImpactProblem<T>& problem, const Three<T>& sticking);

template <class T>
struct Slip {
  T x, y, s, p, D;
};

template <class T>
class Piece;

template <class T>
class Slide {
 public:
  explicit Slide(const ImpactProblem<T>& problem);

  const std::optional<T>& stopped() const { return stopped_; }
  std::unique_ptr<Phase<T>> next(const ImpactProgress<T>& progress);

 private:
  const ImpactProblem<T>& problem_;
  Tangent<T> tangent_;
  Slip<T> first_;
  Slip<T> now_;
  T negligible_;  ///< slip below this gives the same impulse as slip 0 in the energy norm, to the last bits kept
  std::vector<std::unique_ptr<Phase<T>>> pieces_;  ///< pieces of the last series, the next one last
  std::optional<Slip<T>> stop_;                    ///< where slip will stop, once known
  bool settled_ = false;                           ///< the direction of slip is constant to the last bit kept
  T off_before_ = 4;                               ///< rad: of the direction that slip approaches, a step before
  std::optional<T> stopped_;

  ImpactState<T> impact_state(const Slip<T>& slip) const;
  void foresee();
  std::unique_ptr<Phase<T>> straight();
  std::unique_ptr<Phase<T>> skipped_phase(const ImpactProgress<T>& progress);
  void step();

  friend class Piece<T>;
};

extern template class Slide<Float>;
extern template class Slide<DoubleDouble>;

}  // namespace touchstone::reference
