// An impact's course where the impulse grows along straight lines: without friction, sticking, slipping one way.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "reference/impact_law_impl.h"
#include "reference/impact_root_impl.h"

namespace touchstone::reference {

/// dP/dp = zeta.
template <class T>
class Ray : public Stretch<T> {
 public:
  Ray(const Blow<T>& blow, Moment<T> begin, Three<T> zeta, std::optional<T> length = {})
      : begin_(std::move(begin)),
        zeta_(std::move(zeta)),
        K_zeta_(times(blow.K, zeta_)),
        slope_(inner(blow.N, K_zeta_)) {
    begin_.at = 0;
    if (length) end_ = after(*length);
  }

  const Moment<T>& begin() const override { return begin_; }
  const Moment<T>* end() const override { return end_ ? &*end_ : nullptr; }

  std::optional<Moment<T>> when_p(const T& c, const Moment<T>& from) const override {
    return reached(T(c - from.p), from, &Moment<T>::p, c);
  }

  std::optional<Moment<T>> when_U(const T& c, const Moment<T>& from) const override {
    if (from.U >= c) return from;
    if (slope_ <= 0) return {};
    return reached(T((c - from.U) / slope_), from, &Moment<T>::U, c);
  }

  /// U x + U' x²/2 = c − W, the root at which W rises, in the form that cancels nothing. None where U falls to 0
  /// before, as it may while slip jams. From U < 0 (it jammed before) W falls first.
  std::optional<Moment<T>> when_W(const T& c, const Moment<T>& from) const override {
    const T missing = c - from.W;
    if (missing <= 0) return from;
    const T discriminant = from.U * from.U + 2 * slope_ * missing;
    if (discriminant < 0 || (from.U <= 0 && slope_ <= 0)) return {};
    const T last_U = root(discriminant);
    if (from.U < 0) return reached(T((last_U - from.U) / slope_), from, &Moment<T>::W, c);
    return reached(T(2 * missing / (from.U + last_U)), from, &Moment<T>::W, c);
  }

  T slope(const Moment<T>&) const override { return slope_; }
  std::optional<T> rise_left(const Moment<T>&) const override { return {}; }
  bool ends_at_peak() const override { return false; }

 private:
  /// What was asked for is c there, whatever rounding has made of it.
  std::optional<Moment<T>> reached(const T& further, const Moment<T>& from, T Moment<T>::*asked, const T& c) const {
    if (further <= 0) return from;
    const T at = from.at + further;
    if (end_ && at > end_->at) return {};
    Moment<T> moment = after(at);
    moment.*asked = c;
    return moment;
  }

  Moment<T> after(const T& x) const {
    Moment<T> m;
    m.at = x;
    m.p = begin_.p + x;
    m.P = plus(begin_.P, scaled(x, zeta_));
    m.u = plus(begin_.u, scaled(x, K_zeta_));
    m.U = begin_.U + x * slope_;
    m.W = begin_.W + x * (begin_.U + x * slope_ / 2);
    return m;
  }

  Moment<T> begin_;
  Three<T> zeta_, K_zeta_;
  T slope_;
  std::optional<Moment<T>> end_;
};

template <class T>
Moment<T> before(const Blow<T>& blow) {
  Moment<T> m{};
  m.u = blow.u0;
  m.U = inner(blow.u0, blow.N);
  return m;
}

/// K zeta along N, zeta·N = ν²: slip stays 0.
template <class T>
Three<T> sticking_zeta(const Blow<T>& blow) {
  const Three<T> a = times(blow.K_inverse, blow.N);
  return scaled(T(blow.square / inner(blow.N, a)), a);
}

/// Slip 0: stick, or leave along the line on which (t, 1)ᵀ K (t, 1) is least over the disc (docs/design/impulse.md).
template <class T>
std::unique_ptr<Stretch<T>> rest(const Blow<T>& blow, const Moment<T>& stopped) {
  const Three<T> zeta = sticking_zeta(blow);
  if (blow.facts.rest_sticks) return std::make_unique<Ray<T>>(blow, stopped, zeta);
  return std::make_unique<Ray<T>>(blow, stopped, plus(blow.N, diverging(blow, minus(zeta, blow.N))));
}

/// u_t = 0 at once, by a tangential impulse: what friction without limit does before any normal impulse.
template <class T>
Moment<T> caught(const Blow<T>& blow) {
  const Three<T> a = times(blow.K_inverse, blow.N);
  const Three<T> b = times(blow.K_inverse, blow.u0);
  Moment<T> m{};
  m.P = minus(scaled(T(inner(blow.N, b) / inner(blow.N, a)), a), b);
  m.u = plus(blow.u0, times(blow.K, m.P));
  m.U = inner(m.u, blow.N);
  return m;
}

template <class T>
class Lines {
 public:
  explicit Lines(const Blow<T>& blow) : blow_(blow) {}

  /// p when slip stopped, if it has.
  const std::optional<T>& stopped() const { return stopped_; }

  std::unique_ptr<Stretch<T>> next(const Walk<T>& walk) {
    const Facts& facts = blow_.facts;
    if (facts.frictionless) return std::make_unique<Ray<T>>(blow_, before(blow_), blow_.N);
    if (facts.slips && !facts.no_limit && !slid_) return slide();
    stopped_ = walk.now().p;
    return rest(blow_, facts.no_limit ? caught(blow_) : walk.now());
  }

 private:
  std::unique_ptr<Stretch<T>> slide() {
    slid_ = true;
    const Three<T> w = blow_.tangential(blow_.u0);
    const T w2 = inner(w, w);
    const Three<T> zeta = minus(blow_.N, scaled(root(T(blow_.cone / w2)), w));
    const T growth = inner(w, times(blow_.K, zeta)) / w2;
    if (growth >= 0) return std::make_unique<Ray<T>>(blow_, before(blow_), zeta);
    return std::make_unique<Ray<T>>(blow_, before(blow_), zeta, T(-1 / growth));
  }

  const Blow<T>& blow_;
  bool slid_ = false;
  std::optional<T> stopped_;
};

}  // namespace touchstone::reference
