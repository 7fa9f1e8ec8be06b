// The clauses of docs/spec/simulation.md about the impulses that events report, also those of contacts that last, as
// executable properties.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/impulse.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/impact.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Outcome;
using oracle::Point;
using oracle::Real;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace words = oracle::words;
using Kind = Event::Kind;

/// Does the event report what a contact gave over the time since the body's last event?
bool sums_up(const Event& event) { return event.kind == Kind::contact || event.kind == Kind::completed; }

/// One body of an event that reports an impulse: its motion since its last event.
struct Pushed {
  const TrajectoryCase& asked;
  const Event& event;
  bool is_a;
  Scene alone;              ///< the body from its last event on
  oracle::ImpactBody body;  ///< at the event's pose, with the velocity after its last event
  Point force;              ///< N: all but the contact's
  Real seconds;             ///< since the last event

  Pushed(const TrajectoryCase& of, const Event& reported, const Segment& segment, bool first)
      : asked(of), event(reported), is_a(first), alone(segment_scene(of.scene, {segment}, reported.time)) {
    Scene there = alone;
    there.bodies[0].X_WB = after().X_WB;
    body = oracle::impact_body(there, 0, event.p_WC);
    const std::vector<AppliedForce>& forces = alone.motion->forces;
    force = body.mass * of.scene.gravity.cast<Real>();
    if (!forces.empty()) force += forces.back().force_W.cast<Real>();
    seconds = Real{event.time} - segment.from;
  }

  const State& after() const { return is_a ? event.after_a : event.after_b; }
  Point impulse() const { return (is_a ? 1 : -1) * event.P_A_W.cast<Real>(); }
  const Body& solid() const { return alone.bodies[0]; }

  /// N s: what micro-bounces within the envelope may give or leave. No body is faster by them than 2√(2aε), and a
  /// rotation or a slip of at most 4√(2aε) is dropped where a body comes to rest.
  Real of_bounces() const {
    return 8 * std::sqrt(2 * body.mass * force.norm() * static_cast<Real>(envelope(asked.scene)));
  }

  /// N s: the momenta and impulses whose difference the event's impulse is, so it is known to some roundings of them.
  Real momenta() const {
    const Real speeds = after().velocity.v_WBcm.cast<Real>().norm() + body.v_WBcm.norm();
    return body.mass * speeds + seconds * force.norm() + impulse().norm();
  }

  template <class Law>
  Finding compare(const Point& gained, const Point& given, Real allowed, Real size, Law&& law) const {
    const Real u = oracle::unit_roundoff(asked.precision);
    return judge::at_most(
        static_cast<double>((gained - given).norm()),
        {static_cast<double>(allowed), static_cast<double>(u * std::max<Real>(size, 0x1p-900L)), "ulps of the momenta",
         0, static_cast<double>(size)},
        Defect::wrong_momentum,
        [&] { return text(event) + ": " + law + " = " + words::text(Vec3(gained.cast<double>())); },
        [&] { return words::text(Vec3(given.cast<double>())); });
  }

  /// m Δv = P + F t.
  Finding of_momentum() const {
    const Point v = after().velocity.v_WBcm.cast<Real>(), given = impulse() + seconds * force;
    const tolerance::BallisticBound flown = allowance(alone, 0, event.time, asked.precision);
    const Real u = oracle::unit_roundoff(asked.precision);
    const Real size = momenta();
    const Real of_mass = tolerance::mass(solid(), asked.precision).mass / body.mass;
    const bool is_ball = std::holds_alternative<Sphere>(solid().shape);
    return compare(body.mass * (v - body.v_WBcm), given,
                   (8 * u + 2 * of_mass) * size + body.mass * static_cast<Real>(flown.velocity) +
                       (is_ball || !sums_up(event) ? 0 : of_bounces()),
                   size, "m Δv");
  }

  /// I Δω = r × P of a ball, about whose centre no other force has a moment; r keeps its direction on a plane.
  Finding of_spin() const {
    const Point w = after().velocity.w_WB.cast<Real>(), given = body.p_BcmC_W.cross(impulse());
    const tolerance::BallisticBound flown = allowance(alone, 0, event.time, asked.precision);
    const Real u = oracle::unit_roundoff(asked.precision), arm = body.p_BcmC_W.norm(), I = body.moments[2];
    const Real size = I * (w.norm() + body.w_WB.norm()) + arm * momenta();
    const Real of_inertia = tolerance::mass(solid(), asked.precision).inertia / body.moments[0];
    const Real off = 2 * static_cast<Real>(envelope(asked.scene) + flown.place);
    return compare(body.angular_momentum(w - body.w_WB), given,
                   (16 * u + 2 * of_inertia) * size + I * static_cast<Real>(flown.spin) + off * impulse().norm(), size,
                   "I Δω");
  }
};

bool is_uniform_ball(const Body& body, const oracle::ImpactBody& as_known) {
  return std::holds_alternative<Sphere>(body.shape) && as_known.moments[0] == as_known.moments[2] &&
         as_known.p_BBcm.isZero(0);
}

Finding add_up(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = judge::outside("no impulse that is reported");
    for (std::size_t e = 0; e < asked.events(); ++e) {
      const Event& event = (*asked.said.events)[e];
      if (event.kind != Kind::impact && !sums_up(event)) continue;
      if (event.P_A_W.norm() < tolerance::least_in_range(asked.precision)) continue;
      const std::vector<Segment> segments = segments_into(timeline, asked.said, e);
      for (std::size_t k = 0; k < segments.size(); ++k) {
        if (asked.is_fixed(segments[k].body) || (!segments[k].ballistic && !sums_up(event))) continue;
        const Pushed pushed(asked, event, segments[k], k == 0);
        if (worse(worst, pushed.of_momentum())) return worst;
        const bool turns = sums_up(event) && is_uniform_ball(pushed.solid(), pushed.body);
        if (turns && worse(worst, pushed.of_spin())) return worst;
      }
    }
    return worst;
  });
}

/// P·n ≥ 0 and |P_t| ≤ μ P·n.
Finding in_cone(const TrajectoryCase& asked, const Event& event, double mu, double bounces) {
  if (!tolerance::is_unit(event.nhat_BA_W, asked.precision))
    return judge::wrong(Defect::wrong_normal, text(event), "a unit normal");
  const Vec3 n = event.nhat_BA_W.normalized();
  const double P = event.P_A_W.norm(), P_n = event.P_A_W.dot(n);
  const double unit = oracle::unit_roundoff(asked.precision) * P;
  const auto at_most = [&](double beyond, double factor, Defect defect, const char* law) {
    return judge::at_most(
        std::max(0.0, beyond),
        {tolerance::cone(P, factor, asked.precision) + (1 + factor) * bounces, unit, "ulps of the impulse", 0, P},
        defect, [&] { return text(event) + ": P = " + words::text(event.P_A_W); }, [&] { return std::string(law); });
  };
  Finding worst = at_most(-P_n, 0, Defect::pulls, "P·n ≥ 0");
  if (worst.outcome == Outcome::fails || !std::isfinite(mu)) return worst;
  worse(worst, at_most((event.P_A_W - P_n * n).norm() - mu * P_n, mu, Defect::beyond_cone, "|P_t| ≤ mu P·n"));
  return worst;
}

Finding hold(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = judge::outside("no impulse that is reported");
    for (std::size_t e = 0; e < asked.events(); ++e) {
      const Event& event = (*asked.said.events)[e];
      if (event.P_A_W.isZero(0) || event.kind == Kind::force) continue;
      const std::vector<Segment> segments = segments_into(timeline, asked.said, e);
      Real bounces = 0;
      for (std::size_t k = 0; sums_up(event) && k < segments.size(); ++k) {
        if (!asked.is_fixed(segments[k].body))
          bounces = std::max(bounces, Pushed(asked, event, segments[k], k == 0).of_bounces());
      }
      const auto friction = [&](int body) { return scene.bodies[static_cast<std::size_t>(body)].material.friction; };
      if (worse(worst,
                in_cone(asked, event, std::min(friction(event.a), friction(event.b)), static_cast<double>(bounces)))) {
        return worst;
      }
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_impulse_properties() {
  const std::string query = "simulation", clause = "TS-SIMULATION-";
  return {
      {"simulation.impulses_add_up",
       query,
       {clause + "39"},
       "what a contact gave since a body's last event is the change of its momentum",
       add_up},
      {"simulation.impulses_hold",
       query,
       {clause + "40"},
       "each reported impulse pushes, and lies in the friction cone",
       hold},
  };
}

}  // namespace touchstone::properties
