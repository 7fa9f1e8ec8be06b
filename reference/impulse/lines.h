// Phases in which the impulse grows along a straight line: without friction, sticking, or slipping in one direction.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "reference/impulse/law.h"
#include "reference/impulse/root.h"

namespace touchstone::reference {

/// A phase with dP/dp = zeta.
template <class T>
class Ray : public Phase<T> {
 public:
  Ray(const ImpactProblem<T>& problem, ImpactState<T> begin, Three<T> zeta, std::optional<T> length = {})
      : begin_(std::move(begin)),
        zeta_(std::move(zeta)),
        K_zeta_(times(problem.K, zeta_)),
        slope_(inner(problem.N, K_zeta_)) {
    begin_.at = 0;
    if (length) end_ = after(*length);
  }

  const ImpactState<T>& begin() const override { return begin_; }
  const ImpactState<T>* end() const override { return end_ ? &*end_ : nullptr; }

  std::optional<ImpactState<T>> when_p(const T& c, const ImpactState<T>& from) const override {
    return reached(T(c - from.p), from, &ImpactState<T>::p, c);
  }

  std::optional<ImpactState<T>> when_U(const T& c, const ImpactState<T>& from) const override {
    if (from.U >= c) return from;
    if (slope_ <= 0) return {};
    return reached(T((c - from.U) / slope_), from, &ImpactState<T>::U, c);
  }

  /// Solves U x + U' x²/2 = c − W for the root at which W rises, in the form without cancellation. None where U falls
  /// to 0 before, as it may while slip jams. If U < 0 (it jammed before), W falls first.
  std::optional<ImpactState<T>> when_W(const T& c, const ImpactState<T>& from) const override {
    const T missing = c - from.W;
    if (missing <= 0) return from;
    const T discriminant = from.U * from.U + 2 * slope_ * missing;
    if (discriminant < 0 || (from.U <= 0 && slope_ <= 0)) return {};
    const T last_U = root(discriminant);
    if (from.U < 0) return reached(T((last_U - from.U) / slope_), from, &ImpactState<T>::W, c);
    return reached(T(2 * missing / (from.U + last_U)), from, &ImpactState<T>::W, c);
  }

  T slope(const ImpactState<T>&) const override { return slope_; }
  std::optional<T> rise_left(const ImpactState<T>&) const override { return {}; }
  bool ends_at_peak() const override { return false; }

 private:
  /// Sets the requested quantity to c, in spite of rounding.
  std::optional<ImpactState<T>> reached(const T& further, const ImpactState<T>& from, T ImpactState<T>::*asked,
                                        const T& c) const {
    if (further <= 0) return from;
    const T at = from.at + further;
    if (end_ && at > end_->at) return {};
    ImpactState<T> impact_state = after(at);
    impact_state.*asked = c;
    return impact_state;
  }

  ImpactState<T> after(const T& x) const {
    ImpactState<T> m;
    m.at = x;
    m.p = begin_.p + x;
    m.P = plus(begin_.P, scaled(x, zeta_));
    m.u = plus(begin_.u, scaled(x, K_zeta_));
    m.U = begin_.U + x * slope_;
    m.W = begin_.W + x * (begin_.U + x * slope_ / 2);
    return m;
  }

  ImpactState<T> begin_;
  Three<T> zeta_, K_zeta_;
  T slope_;
  std::optional<ImpactState<T>> end_;
};

template <class T>
ImpactState<T> before(const ImpactProblem<T>& problem) {
  ImpactState<T> m{};
  m.u = problem.u0;
  m.U = inner(problem.u0, problem.N);
  return m;
}

/// K zeta along N, zeta·N = ν²: slip stays 0.
template <class T>
Three<T> sticking_zeta(const ImpactProblem<T>& problem) {
  const Three<T> a = times(problem.K_inverse, problem.N);
  return scaled(T(problem.square / inner(problem.N, a)), a);
}

/// Slip is 0: the contact sticks, or slips along the line on which (t, 1)ᵀ K (t, 1) is least over the disc
/// (docs/design/impulse.md).
template <class T>
std::unique_ptr<Phase<T>> rest(const ImpactProblem<T>& problem, const ImpactState<T>& stopped) {
  const Three<T> zeta = sticking_zeta(problem);
  if (problem.facts.rest_sticks) return std::make_unique<Ray<T>>(problem, stopped, zeta);
  return std::make_unique<Ray<T>>(problem, stopped, plus(problem.N, diverging(problem, minus(zeta, problem.N))));
}

/// Makes u_t = 0 at once by a tangential impulse: the effect of unlimited friction before any normal impulse.
template <class T>
ImpactState<T> caught(const ImpactProblem<T>& problem) {
  const Three<T> a = times(problem.K_inverse, problem.N);
  const Three<T> b = times(problem.K_inverse, problem.u0);
  ImpactState<T> m{};
  m.P = minus(scaled(T(inner(problem.N, b) / inner(problem.N, a)), a), b);
  m.u = plus(problem.u0, times(problem.K, m.P));
  m.U = inner(m.u, problem.N);
  return m;
}

template <class T>
class Lines {
 public:
  explicit Lines(const ImpactProblem<T>& problem) : problem_(problem) {}

  /// p at which slip stopped, if it has.
  const std::optional<T>& stopped() const { return stopped_; }

  std::unique_ptr<Phase<T>> next(const ImpactProgress<T>& progress) {
    const Facts& facts = problem_.facts;
    if (facts.frictionless) return std::make_unique<Ray<T>>(problem_, before(problem_), problem_.N);
    if (facts.slips && !facts.no_limit && !slid_) return slide();
    stopped_ = progress.now().p;
    return rest(problem_, facts.no_limit ? caught(problem_) : progress.now());
  }

 private:
  std::unique_ptr<Phase<T>> slide() {
    slid_ = true;
    const Three<T> w = problem_.tangential(problem_.u0);
    const T w2 = inner(w, w);
    const Three<T> zeta = minus(problem_.N, scaled(root(T(problem_.cone / w2)), w));
    const T growth = inner(w, times(problem_.K, zeta)) / w2;
    if (growth >= 0) return std::make_unique<Ray<T>>(problem_, before(problem_), zeta);
    return std::make_unique<Ray<T>>(problem_, before(problem_), zeta, T(-1 / growth));
  }

  const ImpactProblem<T>& problem_;
  bool slid_ = false;
  std::optional<T> stopped_;
};

}  // namespace touchstone::reference
