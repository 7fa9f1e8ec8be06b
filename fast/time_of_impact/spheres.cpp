#include "fast/time_of_impact/spheres.h"

#include <algorithm>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/steady_turn.h"
#include "fast/time_of_impact/look.h"

namespace touchstone::fast::meeting {
namespace {

using motion::Centre;
using motion::Flight;
using Kind = TimeOfImpact::Meeting;

bool is_ball(const motion::Flyer& flyer) {
  return std::holds_alternative<Sphere>(flyer.shape) && flyer.p_BBcm.isZero(0) && flyer.centre_error == 0;
}

double radius(const Flight& flight) { return flight.flyer().solid.parts()[0].radius; }

/// b as seen from a.
struct Apart {
  Vec3 d, v;
  double d_error = 0, v_error = 0;  ///< m; m/s
  double distance = 0;
  double gap = 0, gap_error = 0;  ///< m
  double closing = 0;             ///< −d/dt of the distance (m/s)
  double speed_error = 0;         ///< of `closing`

  bool is_clear() const { return gap > gap_error; }
  bool overlaps() const { return gap < -gap_error; }
  bool approaches() const { return closing > speed_error; }
  bool parts() const { return closing < -speed_error; }
};

/// d up to d_error, r the sum of the radii. The distance rounds by 5u of itself, the gap by u.
Apart apart(const Vec3& d, double d_error, const Vec3& v, double v_error, double r) {
  Apart x{d, v, d_error, v_error, motion::length(d)};
  x.gap = x.distance - r;
  x.gap_error = d_error + 8 * u * (x.distance + r);
  x.closing = -d.dot(v) / x.distance;
  x.speed_error = v_error + 8 * u * v.lpNorm<1>() + v.lpNorm<1>() * (x.gap_error / x.distance);
  return x;
}

/// d rounds by u of what it is the difference of.
Apart apart(const Pair& pair, double t) {
  const Flight &a = pair.a, &b = pair.b;
  const Centre A = a.centre(t, pair.O), B = b.centre(t, pair.O);
  return apart(B.p_WOBcm - A.p_WOBcm, A.error + B.error + 2 * u * (A.p_WOBcm.lpNorm<1>() + B.p_WOBcm.lpNorm<1>()),
               B.v_WBcm - A.v_WBcm, A.v_error + B.v_error + 2 * u * (A.v_WBcm.lpNorm<1>() + B.v_WBcm.lpNorm<1>()),
               radius(a) + radius(b));
}

/// How far both have fallen plays no part. h, v h and the sum round by 4u of v h, and u of d.
Apart after(const Apart& start, double h, double r) {
  const double way = start.v.lpNorm<1>() * h;
  const double error = start.d_error + start.v_error * h + 4 * u * way + u * start.d.lpNorm<1>();
  return apart(start.d + start.v * h, error, start.v, start.v_error, r);
}

Meeting hit(const Pair& pair, const Apart& at_lo, double lo, double hi) {
  const Vec3 n = at_lo.d / at_lo.distance;
  const Vec3 p_OA = pair.a.centre(lo, pair.O).p_WOBcm;
  const Vec3 on_a = p_OA + radius(pair.a) * n;
  const Vec3 on_b = p_OA + (at_lo.d - radius(pair.b) * n);
  return {Kind::hit, lo, hi, 0, pair.in_W((on_a + on_b) / 2, lo), -n};
}

}  // namespace

bool are_falling_balls(const Flight& a, const Flight& b) {
  return is_ball(a.flyer()) && is_ball(b.flyer()) && a.acceleration() == b.acceleration();
}

std::optional<Meeting> spheres(const Flight& a, const Flight& b, double from, double until, double envelope) {
  const Pair pair{a, b, 0, 0, origin(a, b)};
  const Meeting miss{Kind::miss, until, until, 0, Vec3::Zero(), Vec3::Zero()};
  const Apart start = apart(pair, from);
  const double speed = motion::length(start.v);
  if (!(start.distance > 0x1p-400 && start.distance < 0x1p400)) return std::nullopt;
  if (start.parts()) return miss;
  if (!start.approaches()) return std::nullopt;

  const double r = radius(a) + radius(b);
  const double along = start.d.dot(start.v) / speed;
  const double passing = motion::length(start.d - along * (start.v / speed));
  const double passing_error = start.gap_error + start.distance * (start.speed_error / speed + 16 * u);
  if (passing - r > passing_error) return miss;
  if (passing - r > -passing_error) return std::nullopt;

  const double chord = std::sqrt((r - passing) * (r + passing));
  const double h = std::max(0.0, start.gap * (start.distance + r) / (speed * (chord - along)));
  if (h > until - from) {
    const Apart end = after(start, until - from, r);
    return end.is_clear() && end.approaches() ? std::optional(miss) : std::nullopt;
  }
  const double t = from + h;
  double slack = 2 * start.gap_error / (speed * chord / r) + 4 * u * (std::abs(from) + std::abs(t));
  for (int tries = 0; tries < 4; ++tries, slack *= 4) {
    const double lo = std::max(from, t - slack), hi = std::min(t + slack, until);
    const Apart at_lo = after(start, lo - from, r);
    if (lo > from && !(at_lo.is_clear() && at_lo.approaches())) continue;
    if (envelope > 0 && at_lo.gap + at_lo.gap_error <= envelope) return hit(pair, at_lo, lo, lo);
    if (after(start, hi - from, r).overlaps()) return hit(pair, at_lo, lo, hi);
  }
  return std::nullopt;
}

}  // namespace touchstone::fast::meeting
