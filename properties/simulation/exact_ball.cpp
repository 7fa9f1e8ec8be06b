// The clause of docs/spec/simulation.md about one ball among fixed boxes, whose exact motion is known, as an executable
// property.
#include <algorithm>
#include <cmath>

#include "model/limits.h"
#include "oracle/tolerance/constraint.h"
#include "oracle/truth/truth.h"
#include "properties/cases/constraint_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;

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
  Finding place = judge_place(asked, sample);
  // A change that is due at the end of the motion is not in the truth.
  const bool is_end = sample + 1 == asked.scene.motion->sample_times.size();
  if (place.outcome == oracle::Outcome::fails || !asked.bounds[sample].settled || is_end) return place;
  Finding velocity = judge_velocity(asked, sample);
  return velocity.outcome == oracle::Outcome::fails ? velocity : place;
}

Finding exact_ball(const Scene& scene, Subject& subject) {
  return of_exact_ball(scene, [&](const reference::ConstraintTruth& truth) {
    return of_timeline(scene, subject, [&](const TrajectoryCase& trajectory, const Timeline&) {
      if (trajectory.stepping) return judge::outside("a time-stepper");
      return of_certain_samples(scene, trajectory.precision, truth, open_time(scene, truth), trajectory.said,
                                [&](const RollingCase& asked) {
                                  Finding worst;
                                  for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
                                    if (worse(worst, judged_at(asked, sample))) break;
                                  }
                                  return worst;
                                });
    });
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
