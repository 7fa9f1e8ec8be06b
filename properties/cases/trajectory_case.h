// The preconditions of the simulation properties: a scene with a motion, and an answer of the right form.
#pragma once

#include <string>
#include <vector>

#include "model/answers.h"
#include "oracle/judge/judge.h"
#include "oracle/tolerance/motion.h"
#include "properties/cases/timeline.h"
#include "properties/judging/asking.h"

namespace touchstone::properties {

/// What is wrong with the form of a trajectory; "" if nothing. It must have a state for each body at each complete
/// time; events in the order of (time, a, b), of existing bodies, a < b, not before the start of either and not after
/// the end; and exactly one event for each applied force that begins during the motion, at its time.
std::string fault_in_form(const Scene& scene, const Trajectory& said);

std::vector<State> first_states(const Scene& scene);

bool fixed_bodies_rest(const Scene& scene);

/// Bodies i and k of the scene in these poses.
Scene posed_pair(const Scene& scene, std::size_t i, const Pose& X_Wi, std::size_t k, const Pose& X_Wk);

struct TrajectoryCase {
  const Scene& scene;
  oracle::Precision precision;
  const Trajectory& said;
  double end;                                       ///< s; the trajectory is complete until then
  const std::optional<oracle::Stepping>& stepping;  ///< as the subject's card declares it
  const oracle::DistanceTolerance& distances;       ///< likewise
  const oracle::Dynamics& dynamics;                 ///< likewise

  bool is_fixed(std::size_t body) const { return std::holds_alternative<Fixed>(scene.bodies[body].mass); }
  bool has_started(std::size_t body, double time) const {
    const std::vector<double>& starts = scene.motion->start_times;
    return starts.empty() || starts[body] <= time;
  }
  /// The number of complete sample times.
  std::size_t samples() const { return said.states.size(); }
  double time(std::size_t sample) const { return scene.motion->sample_times[sample]; }
  std::size_t events() const { return said.events ? said.events->size() : 0; }
};

/// s: the longest step of the adapters (docs/design/simulation.md). What happens within it is granted to a subject that
/// does not report events.
inline constexpr oracle::Real longest_step = 1.0L / 256;

/// 1: smaller components, relative to what they are computed from, are rounding of the judge's own long doubles.
inline constexpr oracle::Real negligible = 0x1p-40L;

/// Passes scenes with a motion of solids that are exact in the subject's precision, and answers of the right form, to
/// judge_it(const TrajectoryCase&). The property simulation.ordered reports what is wrong in form.
template <class JudgeIt>
oracle::Finding of_trajectory(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  if (!scene.motion) return oracle::judge::outside("no motion");
  return of_scene(scene, subject, [&] {
    return oracle::judge::given(subject.simulation(scene), [&](const Trajectory& said) {
      if (!fault_in_form(scene, said).empty())
        return oracle::judge::outside("not a trajectory; see simulation.ordered");
      return judge_it(TrajectoryCase{scene, subject.card().precision, said, complete_until(scene, said),
                                     subject.card().stepping, subject.card().distance_tolerance,
                                     subject.card().dynamics});
    });
  });
}

/// The same for answers with events: judge_it(const TrajectoryCase&, const Timeline&).
template <class JudgeIt>
oracle::Finding of_timeline(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!asked.said.events) return oracle::judge::silent("its events");
    return judge_it(asked, timeline(scene, asked.said));
  });
}

/// Keeps the finding with the greatest error relative to its bound; anything judged replaces `outside`. Returns true
/// for a failure, which ends the search.
bool worse(oracle::Finding& worst, oracle::Finding next);

/// A bound in metres, counted in ulps of the scene's scale.
oracle::judge::Allowance in_ulps_of_place(const TrajectoryCase& asked, double bound);

/// m: upper bound of the distance of the body's points in one pose from those in another.
double displacement(const Body& body, const Pose& said, const Pose& expected);

/// The bound of body k's ballistic motion at a time, the rounding of the answer, and four for the judge's expectation.
oracle::tolerance::BallisticBound allowance(const Scene& ballistic_scene, std::size_t k, double time,
                                            oracle::Precision precision);

/// Checks the pose of body k of the ballistic scene `flying` at a time; check_state() also checks its velocities.
oracle::Finding check_pose(const TrajectoryCase& asked, const Scene& ballistic_scene, std::size_t k, double time,
                           const Pose& said);
oracle::Finding check_state(const TrajectoryCase& asked, const Scene& ballistic_scene, std::size_t k, double time,
                            const State& said);

std::string text(const Event& event);

}  // namespace touchstone::properties
