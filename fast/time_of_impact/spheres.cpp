#include "fast/time_of_impact/spheres.h"

#include <algorithm>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/steady_turn.h"

namespace touchstone::fast::meeting {
namespace {

using motion::Centre;
using motion::Flight;
using Kind = TimeOfImpact::Meeting;

bool is_ball(const motion::Flyer& flyer) {
  return std::holds_alternative<Sphere>(flyer.shape) && flyer.p_BBcm.isZero(0) && flyer.centre_error == 0;
}

double radius(const Flight& flight) { return flight.flyer().solid.parts()[0].radius; }

/// b as seen from a at one time.
struct Apart {
  Vec3 p_OA, d, v;
  double distance = 0;
  double gap = 0, gap_error = 0;  ///< m
  double closing = 0;             ///< −d/dt of the distance (m/s)
  double speed_error = 0;         ///< of v, and so of `closing`

  bool is_clear() const { return gap > gap_error; }
  bool overlaps() const { return gap < -gap_error; }
  bool approaches() const { return closing > speed_error; }
  bool parts() const { return closing < -speed_error; }
};

/// d rounds by u of what it is the difference of, the distance by 5u, the gap by u.
Apart apart(const Flight& a, const Flight& b, double t, const Vec3& p_WO) {
  const Centre A = a.centre(t, p_WO), B = b.centre(t, p_WO);
  const double r = radius(a) + radius(b);
  Apart x;
  x.p_OA = A.p_WOBcm;
  x.d = B.p_WOBcm - A.p_WOBcm;
  x.v = B.v_WBcm - A.v_WBcm;
  x.distance = motion::length(x.d);
  x.gap = x.distance - r;
  x.gap_error = A.error + B.error + 2 * u * (A.p_WOBcm.lpNorm<1>() + B.p_WOBcm.lpNorm<1>()) + 8 * u * (x.distance + r);
  x.closing = -x.d.dot(x.v) / x.distance;
  x.speed_error = A.v_error + B.v_error + 2 * u * (A.v_WBcm.lpNorm<1>() + B.v_WBcm.lpNorm<1>()) +
                  8 * u * x.v.lpNorm<1>() + x.v.lpNorm<1>() * (x.gap_error / x.distance);
  return x;
}

Meeting hit(const Flight& a, const Flight& b, const Apart& at_lo, double lo, double hi, const Vec3& p_WO) {
  const Vec3 n = at_lo.d / at_lo.distance;
  const Vec3 on_a = at_lo.p_OA + radius(a) * n;
  const Vec3 on_b = at_lo.p_OA + (at_lo.d - radius(b) * n);
  return {Kind::hit, lo, hi, 0, p_WO + (on_a + on_b) / 2, -n};
}

}  // namespace

bool are_falling_balls(const Flight& a, const Flight& b) {
  return is_ball(a.flyer()) && is_ball(b.flyer()) && a.acceleration() == b.acceleration();
}

std::optional<Meeting> spheres(const Flight& a, const Flight& b, double from, double until, double envelope) {
  const Vec3& p_WO = a.start().p_WB;
  const Meeting miss{Kind::miss, until, until, 0, Vec3::Zero(), Vec3::Zero()};
  const Apart start = apart(a, b, from, p_WO);
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
    const Apart end = apart(a, b, until, p_WO);
    return end.is_clear() && end.approaches() ? std::optional(miss) : std::nullopt;
  }
  const double t = from + h;
  double slack = 2 * start.gap_error / (speed * chord / r) + 4 * u * (std::abs(from) + std::abs(t));
  for (int tries = 0; tries < 4; ++tries, slack *= 4) {
    const double lo = std::max(from, t - slack), hi = std::min(t + slack, until);
    const Apart at_lo = apart(a, b, lo, p_WO);
    if (lo > from && !(at_lo.is_clear() && at_lo.approaches())) continue;
    if (envelope > 0 && at_lo.gap + at_lo.gap_error <= envelope) return hit(a, b, at_lo, lo, lo, p_WO);
    if (apart(a, b, hi, p_WO).overlaps()) return hit(a, b, at_lo, lo, hi, p_WO);
  }
  return std::nullopt;
}

}  // namespace touchstone::fast::meeting
