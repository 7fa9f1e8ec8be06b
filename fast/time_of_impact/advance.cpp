#include "fast/time_of_impact/advance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/steady_turn.h"

namespace touchstone::fast::meeting {
namespace {

using motion::Centre;
using Kind = TimeOfImpact::Meeting;

constexpr int most_looks = 200'000;

/// t + h, or a double before it where rounding would go further.
double later(double t, double h) {
  const double sum = t + h;
  return sum - t <= h * (1 - 2 * u) ? sum : std::max(t, sum - 2 * u * std::abs(sum));
}

/// How long the balls around the two centres of mass surely keep apart; none if they are near each other or meet. Their
/// gap along the line of centres is a parabola.
std::optional<double> balls_apart(const Pair& pair, double t) {
  const Centre a = pair.a.centre(t, pair.O), b = pair.b.centre(t, pair.O);
  const Vec3 d = b.p_WOBcm - a.p_WOBcm;
  const double radii = pair.a.flyer().radius + pair.b.flyer().radius + pair.swelling.at(t);
  const double distance = motion::length(d);
  const double gap = distance - radii - 8 * u * (distance + radii) - (a.error + b.error);
  if (!(gap > radii / 64)) return std::nullopt;
  const Vec3 n = d / distance;
  const Vec3 v = b.v_WBcm - a.v_WBcm, fall = pair.b.acceleration() - pair.a.acceleration();
  const double s = n.dot(v) - 8 * u * v.lpNorm<1>() - (a.v_error + b.v_error) - pair.swelling.rate;
  const double seen =
      (pair.a.acceleration() - pair.O.a_WO).lpNorm<1>() + (pair.b.acceleration() - pair.O.a_WO).lpNorm<1>();
  const double c = n.dot(fall) - 128 * u * seen;
  return first_root(gap, s, std::min(0.0, c)) * (1 - 0x1p-30);
}

class Advance {
 public:
  Advance(const Pair& pair, double from, double until, double envelope, lin_canny::FeaturePair& memory)
      : pair_(pair), from_(from), until_(until), envelope_(envelope), memory_(memory), t_(from) {}

  Meeting run() {
    while (++looks_ <= most_looks) {
      if (const std::optional<double> h = balls_apart(pair_, t_)) {
        if (!go_on(*h)) return apart();
        continue;
      }
      const Look look(pair_, t_, memory_, known_);
      known_ = look.slab().direction();
      // That the two do not overlap was proved on the way here. At the start any plane across which they part will do;
      // later it must be the one that they came to, or a touch in passing would be overlooked.
      const bool is_good = look.slab().is_clear() || look.slab().parts();
      const std::optional<Slab> other = !is_good && t_ == from_ ? look.parting() : std::nullopt;
      if (is_good || other) {
        const double before = t_;
        if (!go_on(look.clear_until(is_good ? look.slab() : *other, left()))) return apart();
        if (t_ > before) continue;
      }
      if (const std::optional<Meeting> met = touch(look)) return *met;
      if (t_ >= until_) return apart();
    }
    return doubtful(t_, until_, Look(pair_, t_, memory_, known_).at_most());
  }

  int looks() const { return looks_; }

 private:
  /// The time left, rounded up.
  double left() const { return (until_ - t_) * (1 + 2 * u); }

  /// Goes h further, as far as time's grain lets; false at the end.
  bool go_on(double h) {
    if (h >= left()) return false;
    t_ = later(t_, h);
    return true;
  }

  /// No more than rounding keeps the two apart at t_.
  std::optional<Meeting> touch(const Look& look) {
    if (envelope_ > 0 && look.at_most() <= envelope_ && !look.slab().parts()) return hit(look, t_);
    for (double h = first_wait(look);; h *= 2) {
      const double t = std::min(t_ + h, until_);
      lin_canny::FeaturePair memory = memory_;
      const Look next(pair_, t, memory, known_);
      if (next.overlap(look)) return hit(look, t);
      if (next.slab().is_clear()) {
        doubt(look.at_most(), t);
        memory_ = memory;
        return std::nullopt;
      }
      if (t >= until_) return doubtful(t_, until_, look.at_most());
    }
  }

  /// In which the approach, or the fall, takes the two through what rounding hides. Where they hardly approach along
  /// this normal they may along another one: no slower than a sixteenth of what any points could, then.
  double first_wait(const Look& look) const {
    const Slab& slab = look.slab();
    const double depth = 4 * slab.error();
    const double speed = std::max(-slab.least_speed(8 * slab.error()), look.greatest_speed() / 16);
    const double by_speed = speed > 0 ? depth / speed : infinity;
    const double by_fall = slab.greatest_bend() > 0 ? std::sqrt(2 * depth / slab.greatest_bend()) : infinity;
    const double grain = 4 * u * std::abs(t_) + 0x1p-1000;
    return std::max(grain, std::min({by_speed, by_fall, left()}));
  }

  /// They may have met between t_ and t.
  void doubt(double at_most, double t) {
    if (!doubt_) doubt_ = Doubt{t_, t, at_most};
    doubt_->until = t;
    doubt_->gap = std::min(doubt_->gap, at_most);
    t_ = t;
  }

  Meeting hit(const Look& look, double hi) const {
    const double lo = doubt_ ? doubt_->from : t_;
    return {Kind::hit, lo, hi, 0, pair_.in_W(look.middle(), t_), -look.across()};
  }
  Meeting apart() const {
    if (doubt_) return doubtful(doubt_->from, doubt_->until, doubt_->gap);
    return {Kind::miss, until_, until_, 0, Vec3::Zero(), Vec3::Zero()};
  }
  Meeting doubtful(double lo, double hi, double gap) const {
    if (doubt_) return {Kind::undecided, doubt_->from, hi, std::min(gap, doubt_->gap), Vec3::Zero(), -known_};
    return {Kind::undecided, lo, hi, gap, Vec3::Zero(), -known_};
  }

  struct Doubt {
    double from, until, gap;
  };

  const Pair& pair_;
  double from_, until_, envelope_;
  lin_canny::FeaturePair& memory_;
  double t_;
  int looks_ = 0;
  Vec3 known_ = Vec3::Zero();
  std::optional<Doubt> doubt_;
};

}  // namespace

Meeting advance(const Pair& pair, double from, double until, double envelope, lin_canny::FeaturePair& memory) {
  Advance way(pair, from, until, envelope, memory);
  Meeting met = way.run();
  met.looks = way.looks();
  return met;
}

}  // namespace touchstone::fast::meeting
