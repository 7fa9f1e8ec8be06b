#include "reference/time_of_impact/next_impact.h"

#include <algorithm>
#include <cmath>

#include "reference/ballistic_motion.h"
#include "reference/distance.h"

namespace touchstone::reference {
namespace {

using Status = TimeOfImpact::Status;

double start_of(const Scene& pair) { return std::max(pair.motion->start_times[0], pair.motion->start_times[1]); }

Scene at(const Scene& pair, double time) {
  Scene then = pair;
  for (std::size_t b = 0; b < 2; ++b) {
    if (pair.motion->start_times[b] != time) then.bodies[b] = moved(pair, b, time);
  }
  return then;
}

double gap(const Scene& pair, double time) { return distance(at(pair, time)).distance.lo; }

NextImpact next_of(const TimeOfImpactTruth& truth) {
  if (truth.status == Status::miss) return {};
  return {truth.status == Status::hit, truth.time.lo, false};
}

/// While its trajectory is known, an entry of a rotation is enclosed to a few ulps of 1. Then enclosures grow, until
/// they contain every rotation, and the middle of the quaternion's is 0. The limit between the two is a choice.
constexpr double widest_known = 0x1p-40;

bool is_known(const std::array<std::array<Interval, 3>, 3>& R) {
  return std::ranges::all_of(R, [](const auto& row) {
    return std::ranges::all_of(row, [](const Interval& entry) { return entry.hi - entry.lo <= widest_known; });
  });
}

/// A time at which the two are more than the envelope apart, not long after this is first so.
std::optional<double> time_outside(const Scene& pair, double envelope, double from, double until) {
  for (int k = 20; k >= 0; --k) {
    const double time = from + std::ldexp(until - from, -2 * k);
    if (time > from && gap(pair, time) > envelope) return time;
  }
  return std::nullopt;
}

}  // namespace

Body moved(const Scene& scene, std::size_t index, double time) {
  const BallisticTruth truth = ballistic_state(scene, index, time);
  if (!is_known(truth.R_WB)) throw MotionUnknown();
  const auto vec = [](const std::array<Interval, 3>& v) { return Vec3(v[0].middle(), v[1].middle(), v[2].middle()); };
  const auto& q = truth.q_WB;
  Body body = scene.bodies[index];
  body.X_WB = {vec(truth.p_WB), {q[0].middle(), q[1].middle(), q[2].middle(), q[3].middle()}};
  body.velocity = {vec(truth.v_WBcm), vec(truth.w_WB)};
  return body;
}

NextImpact next_impact(const Scene& pair, double envelope) {
  const double start = start_of(pair);
  const double now = gap(pair, start);
  if (now > envelope / 2) return next_of(time_of_distance(pair, envelope / 2, start));
  if (now > 0 && now < envelope * 0x1p-20) return {false, start, true};
  const TimeOfImpactTruth nearer = now > 0 ? time_of_distance(pair, now * 63 / 64, start) : time_of_impact(pair);
  if (const std::optional<double> time = time_outside(pair, envelope, start, nearer.time.lo)) {
    return next_of(time_of_distance(pair, envelope / 2, *time));
  }
  NextImpact next = next_of(nearer);
  next.micro_bounces = true;
  return next;
}

}  // namespace touchstone::reference
