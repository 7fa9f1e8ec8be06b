// The doors of the simulation properties: a scene with a flight, and an answer whose form is right.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "model/answers.h"
#include "oracle/judge.h"
#include "properties/asking.h"
#include "properties/course.h"

namespace touchstone::properties {

/// What is wrong with the form of a trajectory; "" for nothing: a state for each body at each time that is whole,
/// events in the order of (time, a, b), of bodies that are there, a < b, not after the end; each push on the way told
/// at its time, and no other.
std::string fault_in_form(const Scene& scene, const Trajectory& said);

struct TrajectoryCase {
  const Scene& scene;
  oracle::Precision precision;
  const Trajectory& said;
  double end;  ///< s; until when it is whole

  bool is_fixed(std::size_t body) const { return std::holds_alternative<Fixed>(scene.bodies[body].mass); }
  /// The times that are looked at and whole.
  std::size_t looks() const { return said.states.size(); }
  double time(std::size_t look) const { return scene.flight->times[look]; }
  std::size_t events() const { return said.events ? said.events->size() : 0; }
};

/// Passes scenes with a flight of solids that the subject's precision can hold, and answers whose form is right, to
/// judge_it(const TrajectoryCase&). What is wrong in form is for simulation.ordered to say.
template <class JudgeIt>
oracle::Finding of_trajectory(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  if (!scene.flight) return oracle::judge::outside("no flight");
  if (overlap_at_start(scene)) return oracle::judge::outside("bodies that overlap at the start");
  return of_scene(scene, subject, [&] {
    return oracle::judge::given(subject.simulation(scene), [&](const Trajectory& said) {
      if (!fault_in_form(scene, said).empty())
        return oracle::judge::outside("not a trajectory; see simulation.ordered");
      return judge_it(TrajectoryCase{scene, subject.card().precision, said, whole_until(scene, said)});
    });
  });
}

/// The same for answers with events: judge_it(const TrajectoryCase&, const Course&).
template <class JudgeIt>
oracle::Finding of_course(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!asked.said.events) return oracle::judge::silent("its events");
    return judge_it(asked, course(scene, asked.said));
  });
}

/// Keeps the finding with the greatest error against its bound; what is outside gives way to whatever is judged. A
/// failure at once ends the search: true.
bool worse(oracle::Finding& worst, oracle::Finding next);

/// Of answers with events, each impact of bodies in flight: judge_it(const TrajectoryCase&, const Event&, the legs that
/// it ends).
template <class JudgeIt>
oracle::Finding of_impacts(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  return of_course(scene, subject, [&](const TrajectoryCase& asked, const Course& course) {
    oracle::Finding worst = oracle::judge::outside("no impact in flight");
    for (std::size_t e = 0; e < asked.events(); ++e) {
      const Event& event = (*asked.said.events)[e];
      if (event.kind != Event::Kind::impact) continue;
      const std::vector<Leg> legs = legs_into(course, asked.said, e);
      if (!std::ranges::all_of(legs, &Leg::flies)) continue;
      if (worse(worst, judge_it(asked, event, legs))) break;
    }
    return worst;
  });
}

/// A bound in metres, counted in ulps of the scene's scale.
oracle::judge::Allowance in_ulps_of_place(const TrajectoryCase& asked, double bound);

/// Is body k of these, in flight, where it should be at a time? And does it move as it should?
oracle::Finding stands(const TrajectoryCase& asked, const Scene& flying, std::size_t k, double time, const Pose& said);
oracle::Finding arrives(const TrajectoryCase& asked, const Scene& flying, std::size_t k, double time,
                        const State& said);

std::string text(const Event& event);

}  // namespace touchstone::properties
