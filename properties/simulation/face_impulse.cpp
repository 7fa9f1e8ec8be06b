// The clause of docs/spec/simulation.md about what a face gives to a body from one sample to the next.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/impact.h"
#include "properties/cases/box_face.h"
#include "properties/cases/restitution.h"
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
namespace words = oracle::words;

/// A body at one sample, and the sphere that it cannot leave until the next one: a contact with bodies that are fixed
/// and at rest adds no energy, so its speed is at most √(2 (T/m + |g| s)) after a way s, and s ≤ √(2 T/m) t + |g| t²/2.
struct Reach {
  Point centre;       ///< m: the centre of mass
  Point v;            ///< m/s: of it
  Real radius = 0;    ///< m: of a sphere about the centre of mass that contains the body
  Real farthest = 0;  ///< m: of the sphere that it cannot leave
  Real fastest = 0;   ///< m/s: greatest speed of the centre of mass
};

Reach reach(const TrajectoryCase& asked, std::size_t index, const State& state, Real seconds) {
  Scene there;
  there.bodies = {asked.scene.bodies[index]};
  there.bodies[0].X_WB = state.X_WB;
  there.bodies[0].velocity = state.velocity;
  const oracle::ImpactBody body = oracle::impact_body(there, 0, state.X_WB.p_WB);
  const Real g = asked.scene.gravity.cast<Real>().norm();
  const Real start = std::sqrt(body.v_WBcm.squaredNorm() + body.spin_energy_twice(body.w_WB) / body.mass);
  const Real way = start * seconds + g * seconds * seconds / 2;
  Reach found;
  found.centre = state.X_WB.p_WB.cast<Real>() - body.p_BcmC_W;
  found.v = body.v_WBcm;
  found.radius = tolerance::radius(there.bodies[0]) + body.p_BcmC_W.norm();
  found.farthest = 1.01L * (found.radius + way);
  found.fastest = std::sqrt(start * start + 2 * g * way);
  return found;
}

/// The normal of the face that a sphere is above, if it stays above the inside of that face.
std::optional<Point> face_under(const Body& box, const Point& centre, Real farthest) {
  const std::optional<Face> face = face_below(box, centre);
  if (!face) return std::nullopt;
  const Point off = face->in_face(centre - face->middle);
  const bool is_inside = std::abs(off.x()) + farthest < face->half.x() && std::abs(off.y()) + farthest < face->half.y();
  return is_inside ? std::optional<Point>(face->R_WF.col(2)) : std::nullopt;
}

/// Bodies that touch each other may make each other faster than their own energy.
bool any_may_meet(const std::vector<std::optional<Reach>>& reaches) {
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    for (std::size_t k = i + 1; k < reaches.size(); ++k) {
      if (!reaches[i] || !reaches[k]) continue;
      if ((reaches[i]->centre - reaches[k]->centre).norm() <= reaches[i]->farthest + reaches[k]->farthest) return true;
    }
  }
  return false;
}

/// The box, fixed and at rest, from which alone a body can get an impulse until the next sample.
struct OnlyFace {
  std::size_t box;
  Point nhat_W;
};

std::optional<OnlyFace> only_face(const TrajectoryCase& asked, const std::vector<std::optional<Reach>>& reaches,
                                  std::size_t body) {
  const Reach& moving = *reaches[body];
  std::optional<OnlyFace> only;
  for (std::size_t k = 0; k < reaches.size(); ++k) {
    const Body& other = asked.scene.bodies[k];
    const Point off = other.X_WB.p_WB.cast<Real>() - moving.centre;
    if (reaches[k] || off.norm() > moving.farthest + 1.01L * tolerance::radius(other)) continue;
    const bool is_box = std::holds_alternative<Box>(other.shape);
    const std::optional<Point> normal =
        is_box && !only ? face_under(other, moving.centre, moving.farthest) : std::nullopt;
    if (!normal) return std::nullopt;
    only = OnlyFace{k, *normal};
  }
  return only;
}

/// rad: how far a contact's normal may be off in a subject with steps, whose collision detection finds it: a choice.
constexpr Real normal_in_steps = 0x1p-20L;

/// m/s: what a step adds or leaves out at either end of the time between two samples, and its rounding.
double of_steps(const TrajectoryCase& asked, Real g, Real fastest, double time) {
  if (!asked.stepping) return 0;
  const double rounding = tolerance::rounding_of_steps(time, *asked.stepping, asked.precision);
  return static_cast<double>(2 * g * asked.stepping->step + rounding * fastest);
}

std::size_t events_between(const TrajectoryCase& asked, std::size_t body, double from, double until) {
  if (!asked.said.events) return 0;
  return static_cast<std::size_t>(std::ranges::count_if(*asked.said.events, [&](const Event& event) {
    const auto is_its = [&](int k) { return k >= 0 && static_cast<std::size_t>(k) == body; };
    return from <= event.time && event.time <= until && (is_its(event.a) || is_its(event.b));
  }));
}

/// Two consecutive samples, the first of which may be the start.
struct Span {
  double from, until;
  const std::vector<State>&before, &after;
};

Finding judged(const TrajectoryCase& asked, const Span& span, std::size_t index, const Reach& body,
               const OnlyFace& face) {
  const Scene& scene = asked.scene;
  const Material &a = scene.bodies[index].material, &b = scene.bodies[face.box].material;
  const Real mu = std::min(a.friction, b.friction), seconds = Real{span.until} - span.from;
  const Point g = scene.gravity.cast<Real>();
  const Point P = span.after[index].velocity.v_WBcm.cast<Real>() - body.v - seconds * g;
  const Real P_n = P.dot(face.nhat_W), P_t = (P - P_n * face.nhat_W).norm();
  const auto events = static_cast<double>(events_between(asked, index, span.from, span.until));
  const double u = oracle::unit_roundoff(asked.precision);
  const auto speeds = static_cast<double>(body.fastest + g.norm() * seconds);
  const auto bounce = std::sqrt(2 * static_cast<double>(g.norm()) * envelope(scene));
  const Real tilted = asked.stepping ? normal_in_steps * P.norm() : 0;
  const double each = static_cast<double>(tilted) + 8 * (1 + events) * bounce + (64 + 8 * events) * u * speeds +
                      of_steps(asked, g.norm(), body.fastest, span.until);
  const auto friction = static_cast<double>(mu);
  const judge::Allowance allowed{(1 + friction) * each, u * std::max(speeds, 0x1p-900), "ulps of the speeds", 0,
                                 speeds};
  return judge::at_most(
      static_cast<double>(std::max({-P_n, P_t - mu * P_n, Real{0}})), allowed,
      P_n < 0 ? Defect::pulls : Defect::beyond_cone,
      [&] {
        return "to body " + std::to_string(index) + " of 1 kg, from " + words::text(span.from) + " to " +
               words::text(span.until) + " s: P_n = " + words::text(static_cast<double>(P_n)) +
               " N s, |P_t| = " + words::text(static_cast<double>(P_t)) + " N s";
      },
      [&] { return "P_n ≥ 0 and |P_t| ≤ " + words::text(friction) + " P_n"; });
}

Finding face_impulse(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!scene.motion->forces.empty() || !scene.motion->start_times.empty())
      return judge::outside("applied forces, or start times");
    if (!fixed_bodies_rest(scene)) return judge::outside("a fixed body that moves");
    if (asked.stepping && restitution_may_add_energy(scene))
      return judge::outside("impacts in steps that may raise energy");
    const std::vector<State> start = first_states(scene);
    Finding worst = judge::outside("no body that only one face can touch between two samples");
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      const Span span{sample == 0 ? 0 : asked.time(sample - 1), asked.time(sample),
                      sample == 0 ? start : asked.said.states[sample - 1], asked.said.states[sample]};
      std::vector<std::optional<Reach>> reaches;
      for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        reaches.push_back(asked.is_fixed(k) ? std::nullopt
                                            : std::optional(reach(asked, k, span.before[k], span.until - span.from)));
      }
      if (any_may_meet(reaches)) continue;
      for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        const std::optional<OnlyFace> face = reaches[k] ? only_face(asked, reaches, k) : std::nullopt;
        if (face && worse(worst, judged(asked, span, k, *reaches[k], *face))) return worst;
      }
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_face_impulse_properties() {
  return {{"simulation.face_impulse",
           "simulation",
           {"TS-SIMULATION-43"},
           "what a face gives a body between two samples pushes, and lies in the friction cone",
           face_impulse}};
}

}  // namespace touchstone::properties
