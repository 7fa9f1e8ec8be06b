// The clause of docs/spec/simulation.md about a body that slides on a level box which moves itself.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/impact.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Point;
using oracle::Real;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;

/// A straight motion at constant acceleration until a time, then at constant velocity.
struct Track {
  Point p = Point::Zero(), v = Point::Zero(), a = Point::Zero();

  Point velocity(Real t, Real until) const { return v + std::min(t, until) * a; }
  Point place(Real t, Real until) const {
    const Real slow = std::min(t, until);
    return p + slow * v + slow * slow / 2 * a + (t - slow) * velocity(t, until);
  }
};

Track operator-(const Track& b, const Track& a) { return {b.p - a.p, b.v - a.v, b.a - a.a}; }

/// What stands level: its half extents along its own axes, and the height of its centre above its lowest point.
struct Stand {
  bool ball = false;
  Point half = Point::Zero();
  Real height() const { return half.z(); }
};

/// An upper body on a carrier. The carrier is fixed and moves, or is free on a table without friction.
struct Ride {
  std::size_t upper = 0, carrier = 0;
  std::optional<std::size_t> table;
  Track of_upper, of_carrier;
  Real slip_ends = 0;  ///< s
  Real friction = 0;   ///< μ between both
  Real ratio = 0;      ///< mass of the upper body over that of the carrier; 0 for a fixed one
  Real speeds = 0;     ///< m/s: the slip, and what the upper body's spin moves its lowest point by
};

bool turns_about_z(const Quaternion& q) { return q.x == 0 && q.y == 0; }

// A box turned about the vertical alone, or a ball.
std::optional<Stand> base_of(const Body& body) {
  if (const auto* ball = std::get_if<Sphere>(&body.shape)) return Stand{true, Point::Constant(ball->radius)};
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr || !turns_about_z(body.X_WB.q_WB)) return std::nullopt;
  return Stand{false, box->half_extents.cast<Real>()};
}

/// How far from the middle of a level box, as a share of its half width, an offset from there ends.
Real share_of(const Body& box, const Point& off) {
  const Quaternion& q = box.X_WB.q_WB;
  const Real c = q.w * q.w - q.z * q.z, s = 2 * q.w * q.z, n = q.w * q.w + q.z * q.z;
  const Vec3& half = std::get<Box>(box.shape).half_extents;
  return std::max(std::abs(c * off.x() + s * off.y()) / (n * half.x()),
                  std::abs(c * off.y() - s * off.x()) / (n * half.y()));
}

/// The greatest such share on the way up to a time. Coordinates are quadratic, then linear: they are extreme at the
/// ends and where they turn.
Real greatest_share(const Body& box, const Track& off, Real time, Real until, Real reach) {
  const Vec3& half = std::get<Box>(box.shape).half_extents;
  Real share = 0;
  for (const Real at : {Real(0), std::min(time, until), time})
    share = std::max(share, share_of(box, off.place(at, until)));
  const Real turns = off.a.squaredNorm() > 0 ? -off.v.dot(off.a) / off.a.squaredNorm() : 0;
  if (turns > 0 && turns < std::min(time, until)) share = std::max(share, share_of(box, off.place(turns, until)));
  return share + reach / std::min(half.x(), half.y());
}

// As the scene has them: the body that is asked about, what carries it, and the table below that.
std::optional<Ride> roles(const Scene& scene) {
  const auto height = [&](std::size_t i) { return scene.bodies[i].X_WB.p_WB.z(); };
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) order.push_back(i);
  if (order.size() < 2 || order.size() > 3) return std::nullopt;
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) { return height(i) > height(j); });
  Ride ride;
  ride.upper = order[0];
  ride.carrier = order[1];
  if (order.size() == 3) ride.table = order[2];
  const bool fixed_carrier = is_fixed(scene.bodies[ride.carrier]);
  if (is_fixed(scene.bodies[ride.upper]) || fixed_carrier == ride.table.has_value()) return std::nullopt;
  if (ride.table && (!is_fixed(scene.bodies[*ride.table]) || scene.bodies[*ride.table].velocity != Velocity{})) {
    return std::nullopt;
  }
  return ride;
}

/// m: how far the upper body's lowest point is above the lower one's top.
Real gap_of(const Body& upper, const Stand& base, const Body& lower) {
  const Vec3& half = std::get<Box>(lower.shape).half_extents;
  return static_cast<Real>(upper.X_WB.p_WB.z()) - base.height() - lower.X_WB.p_WB.z() - half.z();
}

bool rests_on(const Scene& scene, const Body& upper, const Stand& base, const Body& lower, Real slack) {
  const Real gap = gap_of(upper, base, lower), most = base.ball ? static_cast<Real>(envelope(scene)) : slack;
  return gap >= -slack && gap <= std::max(slack, most);
}

Material material_of(const Body& a, const Body& b) {
  return {std::min(a.material.restitution, b.material.restitution), std::min(a.material.friction, b.material.friction)};
}

// The upper body slips with the velocity of its lowest point relative to the carrier. Friction, μ m g against the slip,
// acts on both in its direction, which therefore stays: slip falls at the rate μ g (1 + λ + m/M), λ = m r²/I for a ball
// and 0 for a box that does not turn, and m/M the ratio of the masses, 0 for a fixed carrier.
//
// On ice the carrier must not turn: the line of friction passes over its centre of mass.
std::optional<Ride> ride_of(const Scene& scene, oracle::Precision precision) {
  std::optional<Ride> ride = roles(scene);
  const Vec3& g = scene.gravity;
  if (!ride || g.x() != 0 || g.y() != 0 || !(g.z() < 0)) return std::nullopt;
  const Body &upper = scene.bodies[ride->upper], &carrier = scene.bodies[ride->carrier];
  const std::optional<Stand> base = base_of(upper), under = base_of(carrier);
  if (!base || !under || under->ball || upper.velocity.v_WBcm.z() != 0) return std::nullopt;
  if (!carrier.velocity.w_WB.isZero(0) || carrier.velocity.v_WBcm.z() != 0) return std::nullopt;
  const oracle::ImpactBody facts = oracle::impact_body(scene, ride->upper, upper.X_WB.p_WB);
  const oracle::ImpactBody below = oracle::impact_body(scene, ride->carrier, carrier.X_WB.p_WB);
  if (!facts.p_BcmC_W.isZero(0) || !below.p_BcmC_W.isZero(0)) return std::nullopt;
  const Material material = material_of(upper, carrier);
  const Real slack = tolerance::distance(scene, precision), press = -g.z(), h = base->height();
  if (!rests_on(scene, upper, *base, carrier, slack)) return std::nullopt;
  Real lambda = 0;
  if (base->ball) {
    if (facts.moments[2] - facts.moments[0] > negligible * facts.moments[2]) return std::nullopt;
    lambda = facts.mass * h * h / facts.moments[0];
  } else if (!facts.w_WB.isZero(0) || material.restitution != 0 ||
             material.friction * h >= 0.875L * base->half.head<2>().minCoeff()) {
    return std::nullopt;  // it turns, or an impact at one of its corners or friction at its base may tip it
  }
  if (ride->table) {
    const Body& table = scene.bodies[*ride->table];
    const std::optional<Stand> ice = base_of(table);
    if (!ice || ice->ball || !rests_on(scene, carrier, *under, table, slack)) return std::nullopt;
    const Material with_table = material_of(carrier, table);
    if (with_table.friction != 0 || with_table.restitution != 0 || material.restitution != 0) return std::nullopt;
    ride->ratio = facts.mass / below.mass;
  }
  ride->friction = material.friction;
  ride->of_upper = {upper.X_WB.p_WB.cast<Real>(), facts.v_WBcm, Point::Zero()};
  ride->of_carrier = {carrier.X_WB.p_WB.cast<Real>(), below.v_WBcm, Point::Zero()};
  Point slip = facts.v_WBcm - below.v_WBcm;
  if (base->ball) slip -= h * facts.w_WB.cross(Point::UnitZ());
  ride->speeds = slip.norm() + (facts.v_WBcm - below.v_WBcm).norm() + h * facts.w_WB.norm();
  if (slip.norm() <= negligible * ride->speeds || material.friction == 0) return ride;
  const Point sigma = slip.normalized();
  const Point off = ride->of_upper.p - ride->of_carrier.p, apart = ride->of_upper.v - ride->of_carrier.v;
  const auto beside = [&](const Point& x) { return std::abs(x.x() * sigma.y() - x.y() * sigma.x()); };
  if (ride->table && (beside(off) > negligible * off.norm() || beside(apart) > negligible * ride->speeds))
    return std::nullopt;
  ride->of_upper.a = -ride->friction * press * sigma;
  ride->of_carrier.a = -ride->ratio * ride->of_upper.a;
  ride->slip_ends = slip.norm() / (ride->friction * press * (1 + lambda + ride->ratio));
  return ride;
}

// Until then the upper body is above the carrier's top with all of its base, and the carrier above the table's. On ice
// the point at which the table's push acts has to be below the carrier: from its middle it is at most by the upper
// body's place and μ times the height at which friction acts, weighed by the masses.
bool stays(const Scene& scene, const Ride& ride, Real time) {
  const Body &upper = scene.bodies[ride.upper], &carrier = scene.bodies[ride.carrier];
  const Track off = ride.of_upper - ride.of_carrier;
  const Stand base = *base_of(upper);
  const Real reach = base.ball ? 0 : base.half.head<2>().norm();
  const Real share = greatest_share(carrier, off, time, ride.slip_ends, reach);
  if (share > 1 - 0x1p-10L) return false;
  if (!ride.table) return true;
  const Body& table = scene.bodies[*ride.table];
  const Point half = std::get<Box>(carrier.shape).half_extents.cast<Real>();
  const Real lever = ride.friction * (2 * half.z() + base.height()) / half.head<2>().minCoeff();
  if (ride.ratio / (1 + ride.ratio) * (share + lever) > 0.875L) return false;
  const Track from_table = ride.of_carrier - Track{table.X_WB.p_WB.cast<Real>(), Point::Zero(), Point::Zero()};
  return greatest_share(table, from_table, time, ride.slip_ends, half.head<2>().norm()) <= 1 - 0x1p-10L;
}

// m/s: how much the upper body's velocity may differ if it bounces within the envelope, with speeds up to b = √(2 g ε);
// on a carrier that itself bounces, up to 2b. Whatever bounces there are, the normal impulses per mass up to a time add
// up to g t within twice that, and friction to μ times it. Friction stops when slip does, so this is the error of the
// velocity. The contact point is within ε of where it should be, which changes the lever of friction by ε/height.
Real freedom_of_upper(const Scene& scene, const Ride& ride) {
  const Real eps = envelope(scene), bounce = std::sqrt(-2 * static_cast<Real>(scene.gravity.z()) * eps);
  const Real height = base_of(scene.bodies[ride.upper])->height();
  return (ride.table ? 4 : 2) * ride.friction * bounce + 2 * eps / height * ride.speeds;
}

// The carrier gets the upper body's impulses, over its own mass.
Finding follows(const TrajectoryCase& asked, const Ride& ride, bool of_carrier, std::size_t sample) {
  const Scene& scene = asked.scene;
  const std::size_t index = of_carrier ? ride.carrier : ride.upper;
  const Track& track = of_carrier ? ride.of_carrier : ride.of_upper;
  const Real time = asked.time(sample), g = -scene.gravity.z();
  const Real speed = ride.of_upper.v.norm() + ride.of_carrier.v.norm() + ride.speeds + g * time;
  const Real of_steps =
      asked.stepping ? tolerance::rounding_of_steps(asked.time(sample), *asked.stepping, asked.precision) : 0;
  const Real rounding = (64 * oracle::unit_roundoff(asked.precision) * (1 + ride.friction) + of_steps) * speed;
  // A step changes the velocity at once, at one of its ends.
  const Real in_a_step = (asked.stepping ? asked.stepping->step : 0) * track.a.norm();
  const Real dv = (of_carrier ? ride.ratio : 1) * freedom_of_upper(scene, ride) + rounding + in_a_step;
  const State& said = asked.said.states[sample][index];
  Point v = said.velocity.v_WBcm.cast<Real>() - track.velocity(time, ride.slip_ends);
  Point p = said.X_WB.p_WB.cast<Real>() - track.place(time, ride.slip_ends);
  v.z() = p.z() = 0;
  const auto words = [](const Point& x) { return oracle::words::text(Vec3(x.cast<double>())); };
  const auto at = [&] {
    return " of body " + std::to_string(index) + " at " + oracle::words::text(asked.time(sample)) + " s";
  };
  const Real of_coordinates = of_steps * (scene.bodies[index].X_WB.p_WB.norm() + speed * time);
  const double allowed =
      static_cast<double>(time * dv + of_coordinates) + envelope(scene) + tolerance::distance(scene, asked.precision);
  Finding place = counted(is_decisive(scene.bodies[index], allowed),
                          judge::at_most(
                              static_cast<double>(p.norm()), in_ulps_of_place(asked, allowed), Defect::wrong_motion,
                              [&] { return "place" + at() + " is off by " + words(p); },
                              [&] { return words(track.place(time, ride.slip_ends)); }));
  // An engine that follows bodies in contact by steps finds the end of slip within a step.
  const bool slip_may_end = std::abs(time - ride.slip_ends) <= longest_step;
  if (slip_may_end || place.outcome == oracle::Outcome::fails) return place;
  const double unit = oracle::unit_roundoff(asked.precision) * static_cast<double>(speed);
  return judge::at_most(
      static_cast<double>(v.norm()),
      {static_cast<double>(dv), unit, "ulps of the speeds", 0, static_cast<double>(speed)}, Defect::wrong_velocity,
      [&] { return "velocity" + at() + " is off by " + words(v); },
      [&] { return words(track.velocity(time, ride.slip_ends)); });
}

// A body that slides on a level box which moves: both change their velocities as friction has it, until slip ends.
Finding rides(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!scene.motion->forces.empty() || !scene.motion->start_times.empty()) {
      return judge::outside("applied forces, or bodies that start later");
    }
    const std::optional<Ride> ride = ride_of(scene, asked.precision);
    if (!ride) return judge::outside("not a body on a level box that moves, fixed or on ice");
    Finding worst = judge::outside("no sample before the body may leave the box");
    for (std::size_t sample = 0; sample < asked.samples() && stays(scene, *ride, asked.time(sample)); ++sample) {
      if (worse(worst, follows(asked, *ride, false, sample))) return worst;
      if (worse(worst, follows(asked, *ride, true, sample))) return worst;
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_carrier_properties() {
  return {{"simulation.carried",
           "simulation",
           {"TS-SIMULATION-34"},
           "a body on a level box that moves slides, and drags it along, as friction has it",
           rides}};
}

}  // namespace touchstone::properties
