// The clause of docs/spec/simulation.md about when the micro-bounces end that an event sums up, as an executable
// property.
#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Real;
using oracle::Subject;
using oracle::tolerance::Bounces;
namespace judge = oracle::judge;
namespace words = oracle::words;
using Kind = Event::Kind;

Finding no_bounces() { return judge::outside("no bounces of a ball on a fixed box that an event sums up"); }

/// A uniform ball and a fixed box that does not move: Poisson's, Stronge's and Newton's law leave e times the speed.
bool is_ball_on_fixed_box(const Scene& scene, std::size_t ball, std::size_t box) {
  const Body &a = scene.bodies[ball], &b = scene.bodies[box];
  return std::holds_alternative<Sphere>(a.shape) && std::holds_alternative<Density>(a.mass) &&
         std::holds_alternative<Box>(b.shape) && std::holds_alternative<Fixed>(b.mass) && b.velocity == Velocity{};
}

std::size_t other_than(const Event& event, std::size_t ball) {
  return static_cast<std::size_t>(static_cast<std::size_t>(event.a) == ball ? event.b : event.a);
}

/// After the impact that ends the segment.
Bounces bounces_after(const TrajectoryCase& asked, const Event& impact, const Segment& segment) {
  const bool is_a = static_cast<std::size_t>(impact.a) == segment.body;
  const State& after = is_a ? impact.after_a : impact.after_b;
  const Velocity &velocity = after.velocity, &before = segment.start.velocity;
  const Vec3 nhat = is_a ? impact.nhat_BA_W : -impact.nhat_BA_W, &gravity = asked.scene.gravity;
  const auto restitution = [&](std::size_t body) { return asked.scene.bodies[body].material.restitution; };
  const double falls = gravity.norm() * (impact.time - segment.from);
  const double reach = after.X_WB.p_WB.norm() + std::get<Sphere>(asked.scene.bodies[segment.body].shape).radius;
  return {nhat.cast<Real>().dot(velocity.v_WBcm.cast<Real>()),
          velocity.v_WBcm.norm() + before.v_WBcm.norm() + falls + reach * (velocity.w_WB.norm() + before.w_WB.norm()),
          -nhat.cast<Real>().dot(gravity.cast<Real>()), gravity.norm(),
          std::min(restitution(segment.body), restitution(other_than(impact, segment.body)))};
}

/// The events of one ball from the impact that ends its segment `at`.
Finding judged(const TrajectoryCase& asked, const std::vector<Segment>& ball, std::size_t at) {
  const auto event = [&](std::size_t k) -> const Event* {
    return k < ball.size() && !ball[k].is_last() ? &(*asked.said.events)[ball[k].ends_with] : nullptr;
  };
  const Event& impact = *event(at);
  std::size_t last = at;
  while (event(last + 1) != nullptr && event(last + 1)->kind == Kind::completed) ++last;
  const bool is_alone = ball[at].from < impact.time;
  if (last == at || !is_alone || !is_ball_on_fixed_box(asked.scene, ball[at].body, other_than(impact, ball[at].body)))
    return no_bounces();
  const Bounces bounces = bounces_after(asked, impact, ball[at]);
  if (!(bounces.speed > 0 && bounces.presses > 0)) return no_bounces();
  const double said = event(last)->time;
  const Real end = impact.time + bounces.seconds();
  // Whatever else happens to the ball ends them sooner.
  const bool is_cut_short = event(last + 1) != nullptr && event(last + 1)->time == said;
  const double off = static_cast<double>(is_cut_short ? std::max<Real>(said - end, 0) : std::abs(said - end));
  const double ulp = static_cast<double>(oracle::unit_roundoff(asked.precision) * end);
  return judge::at_most(
      off,
      {oracle::tolerance::end_of_bounces(bounces, said, asked.precision), ulp, "ulps of the time", 0,
       static_cast<double>(bounces.seconds())},
      said > end ? Defect::too_late : Defect::too_early, [&] { return text(*event(last)); },
      [&] { return text(impact) + ": then bounces until " + words::text(static_cast<double>(end)) + " s"; });
}

Finding bounces_end(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = no_bounces();
    if (!scene.motion->forces.empty()) return worst;
    for (const std::vector<Segment>& body : timeline) {
      for (std::size_t at = 0; at < body.size(); ++at) {
        const bool is_impact = !body[at].is_last() && (*asked.said.events)[body[at].ends_with].kind == Kind::impact;
        if (is_impact && worse(worst, judged(asked, body, at))) return worst;
      }
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_completed_properties() {
  return {{"simulation.bounces_end",
           "simulation",
           {"TS-SIMULATION-45"},
           "micro-bounces that an event sums up end when the series of them does",
           bounces_end}};
}

}  // namespace touchstone::properties
