// How long an impact lasts: the law of restitution as a walk along the stretches of an impact's course.
//
// T is mpq_class or Float. A course is made of stretches on each of which U is monotone in p.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include "reference/impact_impl.h"
#include "reference/linear_impl.h"

namespace touchstone::reference {

/// What was decided exactly, before any number was rounded.
struct Facts {
  bool separating = false;
  bool frictionless = false;
  bool no_limit = false;     ///< μ = ∞
  bool slips = false;        ///< u_t ≠ 0
  bool straight = false;     ///< slip keeps its direction
  bool rest_sticks = false;  ///< once u_t = 0, it stays so
  bool rest_turns = false;   ///< else: along the line of K⁻¹N's tangential part, known without an equation to solve
  bool painleve = false;
};

template <class T>
struct Blow {
  Square<T> K, K_inverse;
  Three<T> u0, N;
  T square;  ///< ν² = N·N
  T cone;    ///< (μ ν)²; 0 if μ is infinite
  T e;
  Law law = Law::poisson;
  Facts facts;

  Three<T> tangential(const Three<T>& a) const { return minus(a, scaled(T(inner(a, N) / square), N)); }
};

template <class T>
struct Moment {
  T p;
  Three<T> P, u;
  T U;
  T W;   ///< ∫ U dp
  T at;  ///< the stretch's own parameter
};

template <class T>
class Stretch {
 public:
  virtual ~Stretch() = default;
  virtual const Moment<T>& begin() const = 0;
  /// None: it goes on for ever.
  virtual const Moment<T>* end() const = 0;

  /// The first moment, not before `from`, at which p, U or W has reached c.
  virtual std::optional<Moment<T>> when_p(const T& c, const Moment<T>& from) const = 0;
  virtual std::optional<Moment<T>> when_U(const T& c, const Moment<T>& from) const = 0;
  virtual std::optional<Moment<T>> when_W(const T& c, const Moment<T>& from) const = 0;

  virtual T slope(const Moment<T>& here) const = 0;  ///< dU/dp
  /// About how much U would still rise before it falls; none: it does not fall.
  virtual std::optional<T> rise_left(const Moment<T>& here) const = 0;
  virtual bool ends_at_peak() const = 0;  ///< of U
};

/// Nothing happens on it: the law has looked.
template <class T>
class Jump : public Stretch<T> {
 public:
  Jump(Moment<T> begin, Moment<T> end, bool ends_at_peak = false)
      : begin_(std::move(begin)), end_(std::move(end)), ends_at_peak_(ends_at_peak) {}
  const Moment<T>& begin() const override { return begin_; }
  const Moment<T>* end() const override { return &end_; }
  std::optional<Moment<T>> when_p(const T&, const Moment<T>&) const override { return {}; }
  std::optional<Moment<T>> when_U(const T&, const Moment<T>&) const override { return {}; }
  std::optional<Moment<T>> when_W(const T&, const Moment<T>&) const override { return {}; }
  T slope(const Moment<T>&) const override { return T(0); }
  std::optional<T> rise_left(const Moment<T>&) const override { return {}; }
  bool ends_at_peak() const override { return ends_at_peak_; }

 private:
  Moment<T> begin_, end_;
  bool ends_at_peak_;
};

/// Compression until U = 0, then restitution until the law says stop; for Poisson's law again if U < 0 then.
template <class T>
class Walk {
 public:
  Walk(const Blow<T>& blow, const Moment<T>& start) : blow_(blow), now_(start), started_(start) {}

  bool done() const { return done_; }
  const Moment<T>& now() const { return now_; }
  const T& p_c() const { return p_c_; }
  bool recompressed() const { return recompressed_; }
  /// The least |missing U| that would have made a jump.
  const std::optional<T>& near_jump() const { return near_jump_; }

  /// Nothing that ends a phase happens between two moments with U monotone between them.
  bool quiet(const Moment<T>& from, const Moment<T>& to) const {
    if (compressing_) return to.U < 0;
    if (blow_.law == Law::poisson) return to.p < goal_;
    if (blow_.law == Law::newton) return to.U < goal_;
    return to.W < goal_ && !(from.U > 0 && to.U < 0);
  }

  void along(const Stretch<T>& stretch) {
    if (stretch.begin().p == started_.p && stretch.slope(started_) < 0) jump_within(T(-started_.U));
    now_ = stretch.begin();
    while (const std::optional<Moment<T>> event = next_event(stretch)) {
      now_ = *event;
      turn(stretch);
      if (done_) return;
    }
    now_ = *stretch.end();
    const bool watches_U = compressing_ || blow_.law == Law::newton;
    if (watches_U && stretch.ends_at_peak()) jump_within(T((compressing_ ? T(0) : goal_) - now_.U));
  }

 private:
  std::optional<Moment<T>> next_event(const Stretch<T>& stretch) const {
    if (compressing_) return stretch.when_U(T(0), now_);
    if (blow_.law == Law::poisson) return stretch.when_p(goal_, now_);
    if (blow_.law == Law::newton) return stretch.when_U(goal_, now_);
    return stretch.when_W(goal_, now_);
  }

  void turn(const Stretch<T>& stretch) {
    if (compressing_) {
      watch_peak(stretch);
      restitute();
      return;
    }
    if (blow_.law == Law::newton) watch_peak(stretch);
    if (blow_.law == Law::poisson && stretch.slope(now_) < 0) jump_within(now_.U < 0 ? T(-now_.U) : now_.U);
    done_ = blow_.law != Law::poisson || !(now_.U < 0);
    if (done_) return;
    recompressed_ = true;
    compressing_ = true;
    started_ = now_;
  }

  void restitute() {
    compressing_ = false;
    if (!recompressed_) p_c_ = now_.p;
    if (blow_.law == Law::poisson) goal_ = now_.p + blow_.e * (now_.p - started_.p);
    if (blow_.law == Law::newton) goal_ = -blow_.e * started_.U;
    if (blow_.law == Law::stronge) goal_ = now_.W - blow_.e * blow_.e * (now_.W - started_.W);
    done_ = blow_.e == 0;  // or else the last bit of U = 0 would decide whether a new compression starts
  }

  void watch_peak(const Stretch<T>& stretch) {
    if (const auto rise = stretch.rise_left(now_)) jump_within(*rise);
  }

  void jump_within(const T& missing) {
    if (!near_jump_ || missing < *near_jump_) near_jump_ = missing;
  }

  const Blow<T>& blow_;
  Moment<T> now_, started_;
  bool compressing_ = true, recompressed_ = false, done_ = false;
  T goal_, p_c_;
  std::optional<T> near_jump_;
};

}  // namespace touchstone::reference
