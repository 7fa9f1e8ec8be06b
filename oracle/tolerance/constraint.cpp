#include "oracle/tolerance/constraint.h"

#include <algorithm>
#include <cmath>

#include "model/infinity.h"
#include "model/limits.h"
#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"
#include "reference/mass.h"

namespace touchstone::oracle::tolerance {
namespace {

using Change = reference::ConstraintTruth::Change;
using Mode = reference::ConstraintTruth::Mode;

// The bounds are those of a method of first order that takes so many steps in a motion. A choice: 4096 steps are usual,
// and an engine may take steps four times as long. More steps would be stricter.
constexpr double steps_granted = 1024;
constexpr double roundings = 0x1p14;  // of a coordinate: a few for each step, for more steps than are granted

double radius_of(const Scene& scene, const reference::ConstraintTruth& truth) {
  return std::get<Sphere>(scene.bodies[static_cast<std::size_t>(truth.ball)].shape).radius;
}

double friction(const Scene& scene, int ball, int other) {
  return std::min(scene.bodies[static_cast<std::size_t>(ball)].material.friction,
                  scene.bodies[static_cast<std::size_t>(other)].material.friction);
}

/// m/s: upper bound of any body's speed, provided that impacts and contacts add no energy.
double greatest_speed(const Scene& scene) {
  double greatest = 0;
  for (const Body& body : scene.bodies) {
    // Spin may become speed: half the energy ½ I w² ≤ ½ m ρ² w², with ρ the body's reach.
    const double reach = 2 * size(body.shape);
    greatest = std::max(greatest, body.velocity.v_WBcm.norm() + reach * body.velocity.w_WB.norm());
  }
  return greatest + scene.gravity.norm() * scene.motion->sample_times.back();
}

}  // namespace

double granted_step(const Scene& scene) { return scene.motion->sample_times.back() / steps_granted; }

// Error bounds of a first-order method with steps δ, beside the exact ball: X for the position (m), V for v and r w
// (m/s).
//
// Between two changes the accelerations are constant, so the errors of the velocities do not grow. The position is
// moved by the velocity at one end of the step and gains an error of ½ A δ per second, A = |v'|: X += L (V + A δ) over
// L seconds, where a factor two allows for a method that is half as good. While the ball slips, a wrong direction of û
// adds |da| ≤ μ N |du|/|u|. Slip lasts at most |u|/rate, with rate ≥ μ N where it stops, so this adds at most |du|, and
// |du| ≤ 2 V. So V is doubled there. (Friction also pulls the error of u to 0.)
//
// A change is a zero of a quantity that passes 0 with the given rate. It comes early or late by s = X/rate + δ, or by 2
// V/rate + δ where slip stops; δ because it is detected only once in each step. During that time the other acceleration
// acts: V += 2 A s, with A the greater of both. (The factor 2 includes a time-stepper that stays at an edge for one or
// two steps more.)
// An impact multiplies the normal velocity by e. For the tangential velocity, either u_t stops (no factor above 1), or
// it changes by −μ P_n/m û, which is (1 + e) μ |u_n| û, with a slip that stays greater than that: factor 1 + 2 (1 + e)
// μ ≤ 1 + 4 μ. In addition n̂, and with it the impulse, is off by the curvature times X and times the length of a step,
// from anywhere on which the box may be seen: V := (2 + 4 μ) V + 2 velocity_jump curvature (X + |v| δ). The error of
// the position is multiplied by e along n̂. Across n̂ it grows by the tangential jump that acts late, which is at most
// μ times the normal one: X := (1 + μ) X + velocity_jump δ.
//
// Each step rounds what weight adds to the velocities, also of a ball at rest: together |g| T is rounded.
//
// All this requires that the approximate ball makes the same changes as the exact one. It does if X stays below the
// distance to any other change and V below half the rate of each crossing (and, at an edge, below half the excess of v²
// over g r, as only then it becomes ballistic too). Where that does not hold, or X reaches a quarter of the radius,
// nothing is claimed from there on.
std::vector<RollingBound> rolling(const Scene& scene, const reference::ConstraintTruth& truth, Precision precision,
                                  double step) {
  const std::vector<double>& times = scene.motion->sample_times;
  const double delta = step, r = radius_of(scene, truth);
  const Vec3& start = scene.bodies[static_cast<std::size_t>(truth.ball)].X_WB.p_WB;
  const double way = start.norm() + truth.speed * times.back();
  double A = truth.first.acceleration, clearance = truth.first.clearance, from = 0;
  double X = envelope(scene) + roundings * unit_roundoff(precision) * way;
  const double weight = scene.gravity.norm() * times.back();
  double V =
      A * delta + roundings * unit_roundoff(precision) * (truth.speed + weight) + envelope(scene) / r * truth.speed;
  double shift = delta;         // uncertainty of the time of the last change
  double unsure_until = delta;  // the last change may come as late as this
  std::vector<RollingBound> bounds;
  const auto sample_until = [&](double end, double early, double velocity_jump) {
    while (bounds.size() < times.size() && times[bounds.size()] <= end) {
      const double t = times[bounds.size()], place = X + (t - from) * (V + A * delta);
      const bool settled = t > unsure_until && t < end - early;
      if (!(place < clearance) || !(place < r / 4)) return false;
      bounds.push_back({place + (settled ? 0 : velocity_jump * early), V, settled});
    }
    return true;
  };
  for (const Change& change : truth.changes) {
    const double end = change.time.lo, mu = friction(scene, truth.ball, change.other);
    const double before = X + (end - from) * (V + A * delta);
    const bool slip = change.kind == Event::Kind::contact;
    const bool same_time = change.rate == 0;  // a consequence of the change before
    const double early = same_time ? 0 : delta + (slip ? 2 * V : before) / change.rate;
    if (!sample_until(end, early, change.velocity_jump)) return bounds;
    X = before;
    if (!(X < clearance) || !(X < r / 4)) return bounds;
    if (!same_time && !slip && !(V + A * delta < change.rate / 2)) return bounds;
    if (change.kind == Event::Kind::release && !same_time) {
      const double over = change.rate * change.rate - r * scene.gravity.norm();
      if (!(2 * change.rate * V + r * scene.gravity.norm() * 0x1p-6 < over / 2)) return bounds;
    }
    if (!same_time) shift = early;
    V += 2 * std::max(A, change.segment.acceleration) * shift;
    if (change.kind == Event::Kind::impact) {
      V = (2 + 4 * mu) * V + 2 * change.velocity_jump * change.curvature * (X + truth.speed * delta);
      X = (1 + mu) * X + change.velocity_jump * delta;
    }
    if (change.segment.mode == Mode::sliding) V *= 2;
    A = change.segment.acceleration;
    clearance = change.segment.clearance;
    from = end;
    unsure_until = std::max(unsure_until, end + early);
  }
  sample_until(infinity, 0, 0);
  return bounds;
}

// The way of the fastest body in a step: a contact is detected after a step at the latest.
double overlap_of_step(const Scene& scene) { return envelope(scene) + granted_step(scene) * 2 * greatest_speed(scene); }

// A step sees where the one before has left the bodies, so what it rounds does not add up. Two bodies, each of which an
// engine may keep by another point (place_as_kept() in oracle/tolerance/tolerance.h).
double rounding_of_places(const Scene& scene, std::size_t a, std::size_t b, Precision precision) {
  const double way = scene.motion->sample_times.back() * greatest_speed(scene);
  return place_as_kept(scene.bodies[a], precision) + place_as_kept(scene.bodies[b], precision) +
         80 * unit_roundoff(precision) * way;
}

// A step moves a body by v δ with the velocity at one end instead of the mean, so its height is off by ½ g δ² for each
// step: for T/δ steps m g ½ g δ T. In addition overlapping bodies may be lifted apart: m g times overlap_of_step().
double energy_of_steps(const Scene& scene) {
  const double g = scene.gravity.norm(), T = scene.motion->sample_times.back();
  double sum = 0;
  for (const auto& mass : reference::mass(scene)) {
    if (mass) sum += mass->mass.hi * g * (g * granted_step(scene) * T + overlap_of_step(scene));
  }
  return sum;
}

// The judge's own sum: 2^-40, far above its rounding. Of an answer each number is next to the right one, 2u: v² is off
// by 4u, the axes of I by 8u and ωᵀIω so by 20u where the moments are alike. Twice for two energies, and twice for
// moments that are not. A needle that spins about its axis may be off by more, which is not granted.
double rounding_of_energies(Precision precision) { return 0x1p-40 + 80 * unit_roundoff(precision); }

}  // namespace touchstone::oracle::tolerance
