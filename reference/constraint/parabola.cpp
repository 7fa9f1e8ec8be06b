#include "reference/constraint/parabola.h"

namespace touchstone::reference {
namespace {

/// How far c is outside [−h, h], with its sign. Does not fall as c grows.
Enclosed beyond(const Enclosed& c, const Enclosed& h) {
  const auto of = [&](const Float& end) {
    const Enclosed x(end, end), above = x - h, below = x + h;
    if (above.is_positive()) return above;
    if (below.is_negative()) return below;
    return Enclosed(std::min(below.lo(), Float(0)), std::max(above.hi(), Float(0)));
  };
  return {of(c.lo()).lo(), of(c.hi()).hi()};
}

/// f(τ) = |excess|² − r² along the path, in the box's axes.
class Gap {
 public:
  Gap(const Parabola& path, const FixedBox& box, const Enclosed& radius)
      : p_(box.in(path.p)),
        v_(box.turned_in(path.v)),
        a_(box.turned_in(path.a)),
        half_(box.half),
        square_of_radius_(square(radius)) {}

  Enclosed value(const Enclosed& from, const Enclosed& span) const { return value(centre(from, span)); }
  Enclosed value(const Enclosed& tau) const { return value(centre(tau, 0)); }
  Enclosed slope(const Enclosed& from, const Enclosed& span) const {
    const EnclosedVec c = centre(from, span), v = velocity(from, span);
    Enclosed sum;
    for (std::size_t i = 0; i < 3; ++i) sum = sum + beyond(c[i], half_[i]) * v[i];
    return 2 * sum;
  }

  /// Is f > 0 on (0, span], given f(0) = 0?
  bool parts(const Enclosed& span) const { return slope(0, span).is_positive(); }
  bool turns_off(const Enclosed& span, const LeavingContact& leaving) const {
    const EnclosedVec c = centre(0, span), v = velocity(0, span);
    const std::size_t other = 3 - leaving.face - leaving.over;
    if (!(half_[other] - magnitude(c[other])).is_positive()) return false;
    if (!(magnitude(c[leaving.face]) - half_[leaving.face]).is_positive()) return false;
    // Beyond the edge, where f starts at |c| = h and |c| grows.
    const Enclosed side = p_[leaving.over].is_positive() ? 1 : -1;
    if (!(side * v[leaving.over]).is_positive()) return false;
    const auto bends = [&](std::size_t i, const Enclosed& out) { return square(v[i]) + out * a_[i]; };
    const Enclosed past = side * Enclosed(Float(0), (side * v[leaving.over] * span).hi());
    return (bends(leaving.over, past) + bends(leaving.face, beyond(c[leaving.face], half_[leaving.face])))
        .is_positive();
  }

 private:
  EnclosedVec centre(const Enclosed& from, const Enclosed& span) const {
    const EnclosedVec start = plus(p_, scaled(from, plus(v_, scaled(from / 2, a_))));
    const EnclosedVec speed = plus(v_, scaled(from, a_));
    const Enclosed within(Float(0), span.hi());
    return plus(start, scaled(within, plus(speed, scaled(within / 2, a_))));
  }
  EnclosedVec velocity(const Enclosed& from, const Enclosed& span) const {
    return plus(v_, scaled(from + Enclosed(Float(0), span.hi()), a_));
  }
  Enclosed value(const EnclosedVec& c) const {
    Enclosed sum;
    for (std::size_t i = 0; i < 3; ++i) sum = sum + square(beyond(c[i], half_[i]));
    return sum - square_of_radius_;
  }

  EnclosedVec p_, v_, a_, half_;
  Enclosed square_of_radius_;
};

Enclosed point(const Float& f) { return {f, f}; }

/// A point between lo and hi, but not the middle: changes tend to be at simple fractions, where f would be 0.
Float point_between(const Float& lo, const Float& hi) { return lo + (hi - lo) * 0.4932; }

/// The zero of f in (lo, hi). Requires f(lo) > 0 > f(hi) and f falling.
Enclosed narrowed(const Gap& gap, Float lo, Float hi) {
  for (int i = 0; i < 300; ++i) {
    const Float inside = point_between(lo, hi);
    const Enclosed f = gap.value(point(inside));
    if (f.holds_zero()) break;
    (f.is_positive() ? lo : hi) = inside;
  }
  return {lo, hi};
}

constexpr int most_pieces = 4096;  // of time; a clear contact takes some dozens, a grazing one all

/// The first zero of f in (from, to]. Requires f(from) > 0.
std::optional<Enclosed> searched(const Gap& gap, const Float& from, const Float& to, const Float& shortest,
                                 int& pieces) {
  const Enclosed start = point(from), span = point(to - from);
  if (gap.value(start, span).is_positive()) return std::nullopt;
  const Enclosed end = gap.value(point(to));
  if (!end.holds_zero() && gap.slope(start, span).is_negative()) {
    if (end.is_positive()) return std::nullopt;
    return narrowed(gap, from, to);
  }
  if (--pieces < 0 || to - from < shortest) throw Undecided("whether the ball meets a box that it comes very near to");
  const Float inside = point_between(from, to);
  if (const auto early = searched(gap, from, inside, shortest, pieces)) return early;
  return searched(gap, inside, to, shortest, pieces);
}

/// The ball has certainly left the box that it touches at 0 by the returned time.
Float left_by(const Gap& gap, const LeavingContact& leaving, const Float& horizon) {
  Float span = horizon;
  for (int i = 0; i < 200; ++i, span /= 2) {
    const Enclosed until = point(span);
    if (leaving.turns_off ? gap.turns_off(until, leaving) : gap.parts(until)) return span;
  }
  throw Undecided("whether the ball parts from a box");
}

}  // namespace

Parabola Parabola::later(const Enclosed& tau) const {
  return {start + tau,
          plus(p, scaled(tau, plus(v, scaled(tau / 2, a)))),
          plus(v, scaled(tau, a)),
          a,
          plus(w, scaled(tau, alpha)),
          alpha};
}

Parabola at_face(const Parabola& path, const Enclosed& tau, const FixedBox& box, std::size_t axis,
                 const Enclosed& radius) {
  EnclosedVec c = box.in(path.later(tau).p);
  const Enclosed side = c[axis].is_positive() ? 1 : -1;
  const Enclosed from = box.in(path.p)[axis], fast = box.turned_in(path.v)[axis], a = box.turned_in(path.a)[axis];
  c[axis] = side * (box.half[axis] + radius);
  const Enclosed speed = -(side * root(square(fast) + 2 * a * (c[axis] - from)));
  Parabola there = path.later(a.holds_zero() ? tau : shared(tau, (speed - fast) / a));
  EnclosedVec v = box.turned_in(there.v);
  v[axis] = shared(v[axis], speed);
  there.p = shared(there.p, plus(box.origin, box.turned_out(c)));
  there.v = shared(there.v, box.turned_out(v));
  return there;
}

EnclosedVec excess(const FixedBox& box, const EnclosedVec& centre_W) {
  const EnclosedVec c = box.in(centre_W);
  return {beyond(c[0], box.half[0]), beyond(c[1], box.half[1]), beyond(c[2], box.half[2])};
}

std::optional<Enclosed> first_contact(const Parabola& path, const FixedBox& box, const Enclosed& radius,
                                      const Enclosed& horizon, const std::optional<LeavingContact>& leaving) {
  const Gap gap(path, box, radius);
  const Float end = horizon.hi();
  const Float from = leaving ? left_by(gap, *leaving, end) : Float(0);
  if (from >= end) return std::nullopt;
  int pieces = most_pieces;
  return searched(gap, from, end, ldexp(end, -120), pieces);
}

Float least_distance(const Parabola& path, const FixedBox& box, const Enclosed& radius, const Enclosed& span) {
  constexpr int pieces = 32;
  const Gap gap(path, box, radius);
  const Enclosed step = span / pieces;
  Float least = gap.value(Enclosed(0), step).lo();
  for (int i = 1; i < pieces; ++i) least = std::min(least, gap.value(step * i, step).lo());
  return (root(Enclosed(least, least) + square(radius)) - radius).lo();
}

}  // namespace touchstone::reference
