// The preconditions of the constraint properties: a scene with a motion and an answer of the right form, and, where
// there is a truth, the exact ball to compare with.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/answers.h"
#include "oracle/judge/judge.h"
#include "oracle/tolerance/constraint.h"
#include "oracle/truth/truth.h"
#include "properties/cases/timeline.h"
#include "properties/judging/asking.h"

namespace touchstone::properties {

/// What is wrong with the form of a stepped trajectory; "" if nothing. It must have a state for each body at each
/// sample up to where it is complete, and events in order of time within the motion, each of two existing bodies a < b;
/// a force's of one body.
std::string fault_of_steps(const Scene& scene, const Trajectory& said);

struct RollingCase {
  const Scene& scene;
  oracle::Precision precision;
  const reference::ConstraintTruth& truth;
  std::vector<oracle::tolerance::RollingBound> bounds;
  const Trajectory& said;

  /// The number of samples that the answer has and that are certain.
  std::size_t samples() const { return std::min(bounds.size(), said.states.size()); }
  const State& ball(std::size_t sample) const { return said.states[sample][static_cast<std::size_t>(truth.ball)]; }
  const reference::BallTruth& exact(std::size_t sample) const { return truth.states[sample]; }
  double radius() const;
};

/// The distance of a point from the box of three intervals.
double off(const Vec3& p, const std::array<Interval, 3>& truth);

/// Pairs in contact at a time, according to the events.
std::set<std::pair<int, int>> in_contact(const std::vector<Event>& events, double time);

/// Passes scenes with a motion of solids, and answers of the right form, to judge_it(const Trajectory&).
template <class JudgeIt>
oracle::Finding of_steps(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  if (!scene.motion) return oracle::judge::outside("no motion");
  return of_scene(scene, subject, [&] {
    return oracle::judge::given(subject.constraint(scene), [&](const Trajectory& said) {
      const std::string fault = fault_of_steps(scene, said);
      if (!fault.empty()) return oracle::judge::outside("not a trajectory; see constraint.survives");
      return judge_it(said);
    });
  });
}

/// Passes scenes with an exact ball to judge_it(const reference::ConstraintTruth&).
template <class JudgeIt>
oracle::Finding of_exact_ball(const Scene& scene, JudgeIt&& judge_it) {
  if (!scene.motion) return oracle::judge::outside("no motion");
  const auto& truth = oracle::truth::constraint(scene);
  if (const auto* reason = std::get_if<std::string>(&truth)) return oracle::judge::outside(*reason);
  return judge_it(std::get<reference::ConstraintTruth>(truth));
}

/// Passes an answer with certain samples to judge_it(const RollingCase&). `step` (s): the step size that is granted.
template <class JudgeIt>
oracle::Finding of_certain_samples(const Scene& scene, oracle::Precision precision,
                                   const reference::ConstraintTruth& truth, double step, const Trajectory& said,
                                   JudgeIt&& judge_it) {
  const RollingCase asked{scene, precision, truth, oracle::tolerance::rolling(scene, truth, precision, step), said};
  if (asked.samples() == 0)
    return oracle::judge::outside("small errors change the ball's motion: rolling, sliding or free");
  return judge_it(asked);
}

/// Passes the answers to `constraint` with certain samples to judge_it(const RollingCase&).
template <class JudgeIt>
oracle::Finding of_rolling(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  return of_exact_ball(scene, [&](const reference::ConstraintTruth& truth) {
    return of_steps(scene, subject, [&](const Trajectory& said) {
      return of_certain_samples(scene, subject.card().precision, truth, oracle::tolerance::granted_step(scene), said,
                                judge_it);
    });
  });
}

/// Compares a state of the ball with the exact one at a sample: its place, or its velocity and spin, which may be off
/// by `bound` (m/s).
oracle::Finding judge_place(const RollingCase& asked, std::size_t sample, const State& ball);
oracle::Finding judge_velocity(const RollingCase& asked, std::size_t sample, const State& ball, double bound);

/// The same of the answer's state at the sample.
oracle::Finding judge_place(const RollingCase& asked, std::size_t sample);
oracle::Finding judge_velocity(const RollingCase& asked, std::size_t sample);

}  // namespace touchstone::properties
