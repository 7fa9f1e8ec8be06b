// The doors of the constraint properties: a scene with a flight and an answer of the right form; and, where there is a
// truth about it, the exact ball beside it.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/answers.h"
#include "oracle/judge.h"
#include "oracle/tolerance_constraint.h"
#include "oracle/truth.h"
#include "properties/asking.h"
#include "properties/course.h"

namespace touchstone::properties {

/// What is wrong with a stepped trajectory's form; "" for nothing: a state for each body at each look up to where it is
/// whole, events in time's order within the flight, of two bodies a < b that are there.
std::string fault_of_steps(const Scene& scene, const Trajectory& said);

struct RollingCase {
  const Scene& scene;
  oracle::Precision precision;
  const reference::ConstraintTruth& truth;
  std::vector<oracle::tolerance::RollingBound> bounds;
  const Trajectory& said;

  /// Looks that the answer has and that are sure.
  std::size_t looks() const { return std::min(bounds.size(), said.states.size()); }
  const State& ball(std::size_t look) const { return said.states[look][static_cast<std::size_t>(truth.ball)]; }
  const reference::BallTruth& exact(std::size_t look) const { return truth.states[look]; }
  double radius() const;
};

/// The distance of a point from the box of three intervals.
double off(const Vec3& p, const std::array<Interval, 3>& truth);

/// Pairs in contact at a time, as events tell.
std::set<std::pair<int, int>> in_contact(const std::vector<Event>& events, double time);

/// Passes scenes with a flight of solids and answers of the right form to judge_it(const Trajectory&).
template <class JudgeIt>
oracle::Finding of_steps(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  if (!scene.flight) return oracle::judge::outside("no flight");
  if (overlap_at_start(scene)) return oracle::judge::outside("bodies that overlap at the start");
  return of_scene(scene, subject, [&] {
    return oracle::judge::given(subject.constraint(scene), [&](const Trajectory& said) {
      const std::string fault = fault_of_steps(scene, said);
      if (!fault.empty()) return oracle::judge::outside("not a trajectory; see constraint.survives");
      return judge_it(said);
    });
  });
}

/// Those about which there is a truth, to judge_it(const RollingCase&).
template <class JudgeIt>
oracle::Finding of_rolling(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  if (!scene.flight) return oracle::judge::outside("no flight");
  const auto* truth = std::get_if<reference::ConstraintTruth>(&oracle::truth::constraint(scene));
  if (truth == nullptr) return oracle::judge::outside(std::get<std::string>(oracle::truth::constraint(scene)));
  return of_steps(scene, subject, [&](const Trajectory& said) {
    const oracle::Precision precision = subject.card().precision;
    const RollingCase asked{scene, precision, *truth, oracle::tolerance::rolling(scene, *truth, precision), said};
    if (asked.looks() == 0) return oracle::judge::outside("small errors change what the ball does");
    return judge_it(asked);
  });
}

}  // namespace touchstone::properties
