// The clause of docs/spec/simulation.md about one ball among fixed boxes, whose exact motion is known, as an executable
// property.
#include <algorithm>
#include <cmath>
#include <variant>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/constraint.h"
#include "oracle/truth/truth.h"
#include "properties/cases/constraint_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;
namespace words = oracle::words;

// s: as a step would, these leave open when something changes. Over an edge a subject may follow the ball in steps, and
// find within one where contact ends. Elsewhere only the envelope leaves it open: a body that falls from ε and rebounds
// is down again after 2 √(2ε/g); a change may come so early and so late.
double open_time(const Scene& scene, const reference::ConstraintTruth& truth) {
  if (std::ranges::count(truth.changes, Event::Kind::release, &reference::ConstraintTruth::Change::kind) > 0) {
    return static_cast<double>(longest_step);
  }
  return std::min(4 * std::sqrt(2 * envelope(scene) / scene.gravity.norm()), oracle::tolerance::granted_step(scene));
}

Finding judged_at(const RollingCase& asked, std::size_t sample) {
  const State& said = asked.ball(sample);
  const reference::BallTruth& exact = asked.exact(sample);
  const auto time = [&] { return " at " + words::text(asked.scene.motion->sample_times[sample]) + " s"; };
  const Finding place = judge::at_most(
      off(said.X_WB.p_WB, exact.p_WB), {asked.bounds[sample].place, 1, "m", asked.radius()}, Defect::wrong_motion,
      [&] { return "the ball's centre is " + words::text(said.X_WB.p_WB) + time(); },
      [&] { return words::text(middle(exact.p_WB)); });
  const bool ends =
      sample + 1 == asked.scene.motion->sample_times.size();  // a change that is due then is not in the truth
  if (place.outcome == oracle::Outcome::fails || !asked.bounds[sample].settled || ends) return place;
  const double v = off(said.velocity.v_WBcm, exact.v_WB), w = asked.radius() * off(said.velocity.w_WB, exact.w_WB);
  const Finding velocity = judge::at_most(
      std::max(v, w), {asked.bounds[sample].speed, 1, "m/s", 0, off(Vec3::Zero(), exact.v_WB)}, Defect::wrong_velocity,
      [&] { return "v = " + words::text(said.velocity.v_WBcm) + ", w = " + words::text(said.velocity.w_WB) + time(); },
      [&] { return "v = " + words::text(middle(exact.v_WB)) + ", w = " + words::text(middle(exact.w_WB)); });
  return velocity.outcome == oracle::Outcome::fails ? velocity : place;
}

Finding exact_ball(const Scene& scene, Subject& subject) {
  if (!scene.motion) return judge::outside("no motion");
  const auto* truth = std::get_if<reference::ConstraintTruth>(&oracle::truth::constraint(scene));
  if (truth == nullptr) return judge::outside(std::get<std::string>(oracle::truth::constraint(scene)));
  return of_timeline(scene, subject, [&](const TrajectoryCase& trajectory, const Timeline&) {
    if (trajectory.stepping) return judge::outside("a time-stepper");
    const RollingCase asked{scene, trajectory.precision, *truth,
                            oracle::tolerance::rolling(scene, *truth, trajectory.precision, open_time(scene, *truth)),
                            trajectory.said};
    if (asked.samples() == 0) return judge::outside("small errors change the ball's motion: rolling, sliding or free");
    Finding worst;
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      if (worse(worst, judged_at(asked, sample))) break;
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_exact_ball_properties() {
  return {{"simulation.exact_ball",
           "simulation",
           {"TS-SIMULATION-38"},
           "a ball among fixed boxes slides, rolls, flies and rebounds as the exact solution does",
           exact_ball}};
}

}  // namespace touchstone::properties
