#include "fast/time_of_impact/spheres.h"

#include <algorithm>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/steady_turn.h"
#include "fast/time_of_impact/separation_query.h"

namespace touchstone::fast::time_of_impact {
namespace {

using motion::BallisticMotion;
using motion::Centre;
using Status = TimeOfImpact::Status;

bool is_ball(const motion::RigidBodyModel& model) {
  return std::holds_alternative<Sphere>(model.shape) && model.p_BBcm.isZero(0) && model.centre_error == 0;
}

double radius(const BallisticMotion& motion) { return motion.model().solid.parts()[0].radius; }

/// The position and velocity of b relative to a.
struct Separation {
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

/// d is known up to d_error, r is the sum of the radii. The distance rounds by 5u of itself, the gap by u.
Separation separation(const Vec3& d, double d_error, const Vec3& v, double v_error, double r) {
  Separation x{d, v, d_error, v_error, motion::length(d)};
  x.gap = x.distance - r;
  x.gap_error = d_error + 8 * u * (x.distance + r);
  x.closing = -d.dot(v) / x.distance;
  x.speed_error = v_error + 8 * u * v.lpNorm<1>() + v.lpNorm<1>() * (x.gap_error / x.distance);
  return x;
}

/// d rounds by u of the positions that it is the difference of.
Separation separation(const Pair& pair, double t) {
  const BallisticMotion &a = pair.a, &b = pair.b;
  const Centre A = a.centre(t, pair.O), B = b.centre(t, pair.O);
  return separation(B.p_WOBcm - A.p_WOBcm, A.error + B.error + 2 * u * (A.p_WOBcm.lpNorm<1>() + B.p_WOBcm.lpNorm<1>()),
                    B.v_WBcm - A.v_WBcm, A.v_error + B.v_error + 2 * u * (A.v_WBcm.lpNorm<1>() + B.v_WBcm.lpNorm<1>()),
                    radius(a) + radius(b));
}

/// The common acceleration cancels. h, v h and the sum round by 4u of v h, and u of d.
Separation after(const Separation& start, double h, double r) {
  const double way = start.v.lpNorm<1>() * h;
  const double error = start.d_error + start.v_error * h + 4 * u * way + u * start.d.lpNorm<1>();
  return separation(start.d + start.v * h, error, start.v, start.v_error, r);
}

FirstContact hit(const Pair& pair, const Separation& at_lo, double lo, double hi) {
  const Vec3 n = at_lo.d / at_lo.distance;
  const Vec3 p_OA = pair.a.centre(lo, pair.O).p_WOBcm;
  const Vec3 on_a = p_OA + radius(pair.a) * n;
  const Vec3 on_b = p_OA + (at_lo.d - radius(pair.b) * n);
  return {Status::hit, lo, hi, 0, pair.in_W((on_a + on_b) / 2, lo), -n};
}

}  // namespace

bool are_falling_balls(const BallisticMotion& a, const BallisticMotion& b) {
  return is_ball(a.model()) && is_ball(b.model()) && a.acceleration() == b.acceleration();
}

std::optional<FirstContact> spheres(const BallisticMotion& a, const BallisticMotion& b, double from, double until,
                                    double envelope) {
  const Pair pair{a, b, 0, 0, origin(a, b)};
  const FirstContact miss{Status::miss, until, until, 0, Vec3::Zero(), Vec3::Zero()};
  const Separation start = separation(pair, from);
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
    const Separation end = after(start, until - from, r);
    return end.is_clear() && end.approaches() ? std::optional(miss) : std::nullopt;
  }
  const double t = from + h;
  double slack = 2 * start.gap_error / (speed * chord / r) + 4 * u * (std::abs(from) + std::abs(t));
  for (int tries = 0; tries < 4; ++tries, slack *= 4) {
    const double lo = std::max(from, t - slack), hi = std::min(t + slack, until);
    const Separation at_lo = after(start, lo - from, r);
    if (lo > from && !(at_lo.is_clear() && at_lo.approaches())) continue;
    if (envelope > 0 && at_lo.gap + at_lo.gap_error <= envelope) return hit(pair, at_lo, lo, lo);
    if (after(start, hi - from, r).overlaps()) return hit(pair, at_lo, lo, hi);
  }
  return std::nullopt;
}

}  // namespace touchstone::fast::time_of_impact
