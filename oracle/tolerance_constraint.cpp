#include "oracle/tolerance_constraint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/limits.h"
#include "oracle/precision.h"
#include "reference/mass.h"

namespace touchstone::oracle::tolerance {
namespace {

using Change = reference::ConstraintTruth::Change;
using Mode = reference::ConstraintTruth::Mode;

constexpr double steps_granted = 1024;
constexpr double roundings = 0x1p14;  // of a coordinate: a few a step, and more steps than are granted

double radius_of(const Scene& scene, const reference::ConstraintTruth& truth) {
  return std::get<Sphere>(scene.bodies[static_cast<std::size_t>(truth.ball)].shape).radius;
}

double friction(const Scene& scene, int ball, int other) {
  return std::min(scene.bodies[static_cast<std::size_t>(ball)].material.friction,
                  scene.bodies[static_cast<std::size_t>(other)].material.friction);
}

/// What lasts no time comes near nothing: the truth says 0 of it.
double of_lasting(double clear) { return clear == 0 ? std::numeric_limits<double>::infinity() : clear; }

/// m/s: no body is faster, if impacts and contacts give it no energy.
double greatest_speed(const Scene& scene) {
  double greatest = 0;
  for (const Body& body : scene.bodies) {
    // Spin may turn into speed: half the energy ½ I w² ≤ ½ m ρ² w², ρ the body's reach.
    const double reach = 2 * size(body.shape);
    greatest = std::max(greatest, body.velocity.v_WBcm.norm() + reach * body.velocity.w_WB.norm());
  }
  return greatest + scene.gravity.norm() * scene.flight->times.back();
}

}  // namespace

double granted_step(const Scene& scene) { return scene.flight->times.back() / steps_granted; }

// A method of first order with steps δ is followed beside the exact ball: errors X of the place (m), V of v and of r w
// (m/s).
//
// Along a stretch accelerations are constant, so velocities keep their error; the place, moved by the velocity of one
// end of the step, gains ½ A δ a second, A = |v'|: X += L (V + A δ) over L seconds, with twice that for a method that
// is half as good. A stretch of slip adds what a wrong direction of û does: |da| ≤ μ N |du|/|u|, and slip lasts
// |u|/rate at most, rate ≥ μ N where it stops: at most |du|, and |du| ≤ 2 V. So V is doubled there (Coulomb pulls the
// error of u to 0 besides).
//
// A change is a zero of something that goes through it with the given rate. It comes early or late by s = X/rate + δ,
// by 2 V/rate + δ where slip stops; δ, since it is seen in a step. In that time the other acceleration acts: V += 2 A
// s, A the greater of both. (The time-stepper lingers at an edge by a step or two: in 2 A δ.) An impact maps velocities
// by e along n̂, and across by one of: u_t stops (no factor above 1), or −μ P_n/m û, which is (1 + e) μ |u_n| û with a
// slip that stays > that: factor 1 + 2 (1 + e) μ ≤ 1 + 4 μ. Then n̂ is off by curvature times X and times the way
// of a step, from which the box may be seen, the impulse with it: V := (2 + 4 μ) V + 2 kick curvature (X + |v| δ). Its
// place error: along n̂ it becomes e times as much; across, by the tangential kick that acts late, ≤ μ of the normal
// one: X := (1 + μ) X + kick δ.
//
// All of this as long as the approximate ball does the same as the exact one: it does, if X stays below the distance to
// any other change, and V below half the rate of each crossing (and, off an edge, below half of what v² has over g r:
// only then does it fly as well). Where that is not so, or X is a quarter of the radius, nothing is claimed any more.
std::vector<RollingBound> rolling(const Scene& scene, const reference::ConstraintTruth& truth, Precision precision) {
  const std::vector<double>& times = scene.flight->times;
  const double delta = granted_step(scene), r = radius_of(scene, truth);
  const Vec3& start = scene.bodies[static_cast<std::size_t>(truth.ball)].X_WB.p_WB;
  const double way = start.norm() + truth.speed * times.back();
  double A = truth.pull, clear = of_lasting(truth.clear), from = 0;
  double X = envelope(scene) + roundings * unit_roundoff(precision) * way;
  double V = A * delta + (roundings * unit_roundoff(precision) + envelope(scene) / r) * truth.speed;
  double shift = delta;         // of the last change's time
  double unsure_until = delta;  // the last change may come as late as this
  std::vector<RollingBound> bounds;
  const auto look_until = [&](double end, double early, double kick) {
    while (bounds.size() < times.size() && times[bounds.size()] <= end) {
      const double t = times[bounds.size()], place = X + (t - from) * (V + A * delta);
      const bool settled = t > unsure_until && t < end - early;
      if (!(place < clear) || !(place < r / 4)) return false;
      bounds.push_back({place + (settled ? 0 : kick * early), V, settled});
    }
    return true;
  };
  for (const Change& change : truth.changes) {
    const double end = change.time.lo, mu = friction(scene, truth.ball, change.other);
    const double before = X + (end - from) * (V + A * delta);
    const bool slip = change.kind == Event::Kind::contact;
    const bool same_time = change.rate == 0;  // follows from the change before
    const double early = same_time ? 0 : delta + (slip ? 2 * V : before) / change.rate;
    if (!look_until(end, early, change.kick)) return bounds;
    X = before;
    if (!(X < clear) || !(X < r / 4)) return bounds;
    if (!same_time && !slip && !(V + A * delta < change.rate / 2)) return bounds;
    if (change.kind == Event::Kind::release && !same_time) {
      const double over = change.rate * change.rate - r * scene.gravity.norm();
      if (!(2 * change.rate * V + r * scene.gravity.norm() * 0x1p-6 < over / 2)) return bounds;
    }
    if (!same_time) shift = early;
    V += 2 * std::max(A, change.pull) * shift;
    if (change.kind == Event::Kind::impact) {
      V = (2 + 4 * mu) * V + 2 * change.kick * change.curvature * (X + truth.speed * delta);
      X = (1 + mu) * X + change.kick * delta;
    }
    if (change.mode == Mode::slides) V *= 2;
    A = change.pull;
    clear = of_lasting(change.clear);
    from = end;
    unsure_until = std::max(unsure_until, end + early);
  }
  look_until(std::numeric_limits<double>::infinity(), 0, 0);
  return bounds;
}

// The fastest body, in a step; a contact that is not seen before is seen then.
double sunk(const Scene& scene) { return envelope(scene) + granted_step(scene) * 2 * greatest_speed(scene); }

// A step moves a body by v δ with the velocity of one end instead of the mean: its height is off by ½ g δ² a step, so
// by T/δ steps m g ½ g δ T; and what overlaps may be lifted out, m g times tolerance::sunk.
double energy_of_steps(const Scene& scene) {
  const double g = scene.gravity.norm(), T = scene.flight->times.back();
  double sum = 0;
  for (const auto& mass : reference::mass(scene)) {
    if (mass) sum += mass->mass.hi * g * (g * granted_step(scene) * T + sunk(scene));
  }
  return sum;
}

}  // namespace touchstone::oracle::tolerance
