// The law of restitution: follows the phases of an impact and decides where compression and restitution end.
//
// T is mpq_class, Float, DoubleDouble or Enclosed. Compression and restitution consist of phases on each of which U is
// monotone in p.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "reference/exact/linear.h"
#include "reference/impulse/impact.h"

namespace touchstone::reference {

/// What is decided exactly, before any number is rounded.
struct Facts {
  bool separating = false;
  bool frictionless = false;
  bool no_limit = false;     ///< μ = ∞
  bool slips = false;        ///< u_t ≠ 0
  bool straight = false;     ///< slip keeps its direction
  bool rest_sticks = false;  ///< once u_t = 0, it stays 0
  bool rest_turns = false;   ///< else slip leaves 0 along K⁻¹N's tangential part, without an equation to solve
  bool painleve = false;
};

template <class T>
struct ImpactProblem {
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
struct ImpactState {
  T p;
  Three<T> P, u;
  T U;
  T W;   ///< ∫ U dp
  T at;  ///< the phase's own parameter
};

template <class T>
class Phase {
 public:
  virtual ~Phase() = default;
  virtual const ImpactState<T>& begin() const = 0;
  /// None: the phase never ends.
  virtual const ImpactState<T>* end() const = 0;

  /// The first state, not before `from`, at which p, U or W has reached c.
  virtual std::optional<ImpactState<T>> when_p(const T& c, const ImpactState<T>& from) const = 0;
  virtual std::optional<ImpactState<T>> when_U(const T& c, const ImpactState<T>& from) const = 0;
  virtual std::optional<ImpactState<T>> when_W(const T& c, const ImpactState<T>& from) const = 0;

  virtual T slope(const ImpactState<T>& here) const = 0;  ///< dU/dp
  /// Estimate of how much U still rises before it falls; none if it does not fall.
  virtual std::optional<T> rise_left(const ImpactState<T>& here) const = 0;
  virtual bool ends_at_peak() const = 0;  ///< does U have its maximum at the end?
};

/// A phase on which neither compression nor restitution ends. The law has already checked this (ImpactProgress::quiet).
template <class T>
class SkippedPhase : public Phase<T> {
 public:
  SkippedPhase(ImpactState<T> begin, ImpactState<T> end, bool ends_at_peak = false)
      : begin_(std::move(begin)), end_(std::move(end)), ends_at_peak_(ends_at_peak) {}
  const ImpactState<T>& begin() const override { return begin_; }
  const ImpactState<T>* end() const override { return &end_; }
  std::optional<ImpactState<T>> when_p(const T&, const ImpactState<T>&) const override { return {}; }
  std::optional<ImpactState<T>> when_U(const T&, const ImpactState<T>&) const override { return {}; }
  std::optional<ImpactState<T>> when_W(const T&, const ImpactState<T>&) const override { return {}; }
  T slope(const ImpactState<T>&) const override { return T(0); }
  std::optional<T> rise_left(const ImpactState<T>&) const override { return {}; }
  bool ends_at_peak() const override { return ends_at_peak_; }

 private:
  ImpactState<T> begin_, end_;
  bool ends_at_peak_;
};

/// The state of the impact along its phases: compression until U = 0, then restitution until the law ends it. With
/// Poisson's law a new compression follows if U < 0 then.
template <class T>
class ImpactProgress {
 public:
  ImpactProgress(const ImpactProblem<T>& problem, const ImpactState<T>& start)
      : problem_(problem), now_(start), started_(start) {}

  bool done() const { return done_; }
  const ImpactState<T>& now() const { return now_; }
  const T& p_c() const { return p_c_; }
  bool recompressed() const { return recompressed_; }
  /// The least change of U (as |ΔU|) that would have made the result jump.
  const std::optional<T>& near_jump() const { return near_jump_; }
  /// dU/dp > 0 wherever U reached its goal, if μ |K_tn| > K_nn: an error of U moves p by the error over this.
  const std::vector<T>& slopes() const { return slopes_; }

  /// True if neither compression nor restitution ends between two states with U monotone between them.
  bool quiet(const ImpactState<T>& from, const ImpactState<T>& to) const {
    if (compressing_) return to.U < 0;
    if (problem_.law == Law::poisson) return to.p < goal_;
    if (problem_.law == Law::newton) return to.U < goal_;
    return to.W < goal_ && !(from.U > 0 && to.U < 0);
  }

  void along(const Phase<T>& phase) {
    if (phase.begin().p == started_.p && phase.slope(started_) < 0) jump_within(T(-started_.U));
    now_ = phase.begin();
    while (const std::optional<ImpactState<T>> event = next_event(phase)) {
      now_ = *event;
      turn(phase);
      if (done_) return;
    }
    now_ = *phase.end();
    const bool watches_U = compressing_ || problem_.law == Law::newton;
    if (watches_U && phase.ends_at_peak()) jump_within(T((compressing_ ? T(0) : goal_) - now_.U));
  }

 private:
  std::optional<ImpactState<T>> next_event(const Phase<T>& phase) const {
    if (compressing_) return phase.when_U(T(0), now_);
    if (problem_.law == Law::poisson) return phase.when_p(goal_, now_);
    if (problem_.law == Law::newton) return phase.when_U(goal_, now_);
    return phase.when_W(goal_, now_);
  }

  void turn(const Phase<T>& phase) {
    if (problem_.facts.painleve && (compressing_ || problem_.law == Law::newton)) slopes_.push_back(phase.slope(now_));
    if (compressing_) {
      watch_peak(phase);
      restitute();
      return;
    }
    if (problem_.law == Law::newton) watch_peak(phase);
    if (problem_.law == Law::poisson && phase.slope(now_) < 0) jump_within(now_.U < 0 ? T(-now_.U) : now_.U);
    done_ = problem_.law != Law::poisson || !(now_.U < 0);
    if (done_) return;
    recompressed_ = true;
    compressing_ = true;
    started_ = now_;
  }

  void restitute() {
    compressing_ = false;
    if (!recompressed_) p_c_ = now_.p;
    if (problem_.law == Law::poisson) goal_ = now_.p + problem_.e * (now_.p - started_.p);
    if (problem_.law == Law::newton) goal_ = -problem_.e * started_.U;
    if (problem_.law == Law::stronge) goal_ = now_.W - problem_.e * problem_.e * (now_.W - started_.W);
    done_ = problem_.e == 0;  // otherwise the last bit of U = 0 would decide whether a new compression starts
  }

  void watch_peak(const Phase<T>& phase) {
    if (const auto rise = phase.rise_left(now_)) jump_within(*rise);
  }

  void jump_within(const T& missing) {
    if (!near_jump_ || missing < *near_jump_) near_jump_ = missing;
  }

  const ImpactProblem<T>& problem_;
  ImpactState<T> now_, started_;
  bool compressing_ = true, recompressed_ = false, done_ = false;
  T goal_, p_c_;
  std::optional<T> near_jump_;
  std::vector<T> slopes_;
};

}  // namespace touchstone::reference
