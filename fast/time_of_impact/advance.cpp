#include "fast/time_of_impact/advance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fast/lin_canny/rotation.h"
#include "fast/mark.h"
#include "fast/motion/steady_turn.h"

namespace touchstone::fast::time_of_impact {
namespace {

using motion::Centre;
using Status = TimeOfImpact::Status;

/// A choice that ends a search: contacts that need more are left undecided, after a second or less.
constexpr int most_queries = 200'000;

/// t + h, or a double less than that where rounding would exceed it.
double later(double t, double h) {
  const double sum = t + h;
  return sum - t <= h * (1 - 2 * u) ? sum : std::max(t, sum - 2 * u * std::abs(sum));
}

/// How long the balls around the two centres of mass stay separated, proved; nothing if they are close or overlap.
/// Their gap along the line of centres is a parabola.
std::optional<double> balls_apart(const Pair& pair, double t) {
  const Centre a = pair.a.centre(t, pair.O), b = pair.b.centre(t, pair.O);
  const Vec3 d = b.p_WOBcm - a.p_WOBcm;
  const double radii = pair.a.model().radius + pair.b.model().radius + pair.inflation.at(t);
  const double distance = motion::length(d);
  const double gap = distance - radii - 8 * u * (distance + radii) - (a.error + b.error);
  if (!(gap > radii / 64)) return std::nullopt;
  const Vec3 n = d / distance;
  const Vec3 v = b.v_WBcm - a.v_WBcm, fall = pair.b.acceleration() - pair.a.acceleration();
  const double s = n.dot(v) - 8 * u * v.lpNorm<1>() - (a.v_error + b.v_error) - pair.inflation.rate;
  const double seen =
      (pair.a.acceleration() - pair.O.a_WO).lpNorm<1>() + (pair.b.acceleration() - pair.O.a_WO).lpNorm<1>();
  const double c = n.dot(fall) - 128 * u * seen;
  return first_root(gap, s, std::min(0.0, c)) * (1 - 0x1p-30);
}

class Advance {
 public:
  Advance(const Pair& pair, double from, double until, double envelope, lin_canny::FeaturePair& memory)
      : pair_(pair), from_(from), until_(until), envelope_(envelope), memory_(memory), t_(from) {}

  FirstContact run() {
    while (++queries_ <= most_queries) {
      if (const std::optional<double> h = balls_apart(pair_, t_)) {
        mark(Mark::toi_balls);
        const double before = t_;
        if (!go_on(*h)) return apart();
        if (t_ > before) continue;
      }
      mark(Mark::toi_query);
      const SeparationQuery query(pair_, t_, memory_, known_);
      known_ = query.plane().direction();
      // That the two do not overlap was proved on the way here. At the start, any plane along whose normal they
      // separate will do. Later it must be the plane of this query, or a grazing contact would be missed.
      const bool is_exact = has_exact_poses();
      const bool is_good = query.plane().is_clear() || (query.plane().parts() && !is_exact);
      const std::optional<SeparatingPlane> other = !is_good && t_ == from_ ? query.parting(is_exact) : std::nullopt;
      if (other) mark(Mark::toi_parting);
      if (is_good || other) {
        const double before = t_;
        if (!go_on(query.clear_until(is_good ? query.plane() : *other, left()))) return apart();
        if (t_ > before) continue;
      }
      if (const std::optional<FirstContact> met = touch(query)) return *met;
      if (t_ >= until_) return apart();
    }
    FirstContact met = doubtful(t_, until_, SeparationQuery(pair_, t_, memory_, known_).at_most());
    met.is_cut_off = true;
    return met;
  }

  int queries() const { return queries_; }

 private:
  /// The remaining time, rounded up.
  double left() const { return (until_ - t_) * (1 + 2 * u); }

  /// With an envelope the two need not be separated exactly.
  bool has_exact_poses() const {
    return t_ == from_ && from_ == pair_.a.since() && from_ == pair_.b.since() && envelope_ == 0 &&
           pair_.inflation.is_none() && pair_.A().radius + pair_.B().radius == 0;
  }

  /// Advances by h, rounded down; returns false at the end.
  bool go_on(double h) {
    if (h >= left()) return false;
    t_ = later(t_, h);
    return true;
  }

  /// At t_ only rounding separates the two.
  std::optional<FirstContact> touch(const SeparationQuery& query) {
    if (envelope_ > 0 && query.at_most() <= envelope_ && !query.plane().parts()) return hit(query, t_);
    const double first = first_wait(query);
    for (double h = first;; h *= 2) {
      const double t = std::min(t_ + h, until_);
      lin_canny::FeaturePair memory = memory_;
      // Mostly they overlap by then, and no plane separates them.
      const SeparationQuery next = after_wait(t, memory, h > 32 * first ? Planes::all : Planes::likely);
      if (next.overlap(query)) return hit(query, sooner(query, h > first ? t - h / 2 : t_, t, is_deep(next)));
      if (next.plane().is_clear()) {
        if (may_have_met(next, t - t_)) doubt(query.at_most(), t);
        t_ = t;
        memory_ = memory;
        return std::nullopt;
      }
      if (t >= until_) return doubtful(t_, until_, query.at_most());
    }
  }

  SeparationQuery after_wait(double t, lin_canny::FeaturePair& memory, Planes planes) {
    mark(Mark::toi_wait);
    ++queries_;
    return {pair_, t, memory, known_, planes};
  }

  /// Whether the two overlap by more than rounding hides: after a grazing approach a long wait may end so.
  static bool is_deep(const SeparationQuery& overlapping) {
    return overlapping.plane().gap() < -8 * overlapping.plane().error();
  }

  /// A time of overlap: `hi`, or one that is found by halving the interval from `lo`, at which none was proved: twice,
  /// and on as long as the overlap is deep.
  double sooner(const SeparationQuery& query, double lo, double hi, bool deep) {
    for (int halvings = 0; halvings < 2 || deep; ++halvings) {
      const double t = lo + (hi - lo) / 2;
      if (!(lo < t && t < hi)) break;
      lin_canny::FeaturePair memory = memory_;
      const SeparationQuery between = after_wait(t, memory, Planes::likely);
      const bool overlap = between.overlap(query);
      (overlap ? hi : lo) = t;
      if (overlap) deep = is_deep(between);
    }
    return hi;
  }

  /// The time in which approach, or acceleration, carries the two through the gap that rounding hides. Where they
  /// hardly approach along this normal, they may along another one: assumes at least a sixteenth of the greatest speed
  /// of any points.
  double first_wait(const SeparationQuery& query) const {
    const SeparatingPlane& plane = query.plane();
    const double depth = 4 * plane.error();
    const double speed = std::max(-plane.least_speed(8 * plane.error()), query.greatest_speed() / 16);
    const double by_speed = speed > 0 ? depth / speed : infinity;
    const double by_fall = plane.greatest_bend() > 0 ? std::sqrt(2 * depth / plane.greatest_bend()) : infinity;
    const double grain = 4 * u * std::abs(t_) + 0x1p-1000;
    return std::max(grain, std::min({by_speed, by_fall, left()}));
  }

  /// Whether motion through the gap is possible in the time h before. Within a motion |ω| at most doubles.
  bool may_have_met(const SeparationQuery& now, double h) const {
    const double speed = now.greatest_speed() + now.plane().greatest_bend() * h + pair_.inflation.rate;
    return !(now.plane().gap() > 2 * speed * h);
  }

  /// They may have touched between t_ and t.
  void doubt(double at_most, double t) {
    mark(Mark::toi_doubt);
    if (!doubt_) doubt_ = Doubt{t_, t, at_most};
    doubt_->until = t;
    doubt_->gap = std::min(doubt_->gap, at_most);
  }

  FirstContact hit(const SeparationQuery& query, double hi) const {
    const double lo = doubt_ ? doubt_->from : t_;
    return {Status::hit, lo, hi, 0, pair_.in_W(query.middle(), t_), -query.across()};
  }
  FirstContact apart() const {
    if (doubt_) return doubtful(doubt_->from, doubt_->until, doubt_->gap);
    return {Status::miss, until_, until_, 0, Vec3::Zero(), Vec3::Zero()};
  }
  FirstContact doubtful(double lo, double hi, double gap) const {
    if (doubt_) return {Status::undecided, doubt_->from, hi, std::min(gap, doubt_->gap), Vec3::Zero(), -known_};
    return {Status::undecided, lo, hi, gap, Vec3::Zero(), -known_};
  }

  struct Doubt {
    double from, until, gap;
  };

  const Pair& pair_;
  double from_, until_, envelope_;
  lin_canny::FeaturePair& memory_;
  double t_;
  int queries_ = 0;
  Vec3 known_ = Vec3::Zero();
  std::optional<Doubt> doubt_;
};

}  // namespace

FirstContact advance(const Pair& pair, double from, double until, double envelope, lin_canny::FeaturePair& memory) {
  mark(Mark::toi_search);
  Advance way(pair, from, until, envelope, memory);
  FirstContact met = way.run();
  met.queries = way.queries();
  return met;
}

}  // namespace touchstone::fast::time_of_impact
