// What the events of an answer to `constraint` say of an exact ball: TS-CONSTRAINT-22.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/judge/words.h"
#include "oracle/tolerance/tolerance.h"
#include "properties/cases/constraint_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace words = oracle::words;
using Change = reference::ConstraintTruth::Change;

/// A change that a stepper sees within so many granted steps has acted then. A choice: the bound on a velocity grows at
/// each change.
constexpr double steps_until_settled = 4;

/// s
double time_until_settled(const Scene& scene) { return steps_until_settled * tolerance::granted_step(scene); }

/// The scene, sampled at the events after the start and a little later, and at its end.
Scene sampled_at(const Scene& scene, const std::vector<Event>& events) {
  const double end = scene.motion->sample_times.back();
  std::vector<double> times = {end};
  for (const Event& event : events) {
    if (!(event.time > 0 && event.time < end)) continue;
    times.push_back(event.time);
    times.push_back(std::min(end, event.time + time_until_settled(scene)));
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  Scene sampled = scene;
  sampled.motion->sample_times = std::move(times);
  return sampled;
}

std::size_t index_of(const Scene& scene, double time) {
  return static_cast<std::size_t>(std::ranges::lower_bound(scene.motion->sample_times, time) -
                                  scene.motion->sample_times.begin());
}

/// An event of the ball, and the sample at its time.
struct AtEvent {
  const RollingCase& asked;
  const Event& event;
  std::size_t sample;

  bool ball_is_a() const { return event.a == asked.truth.ball; }
  const State& ball() const { return ball_is_a() ? event.after_a : event.after_b; }
};

/// Where the two press on each other the point is on the ball, against the normal; the ball may be as deep in the box
/// as a step takes it.
Finding judge_point_at(const AtEvent& at) {
  if (at.event.P_A_W == Vec3::Zero()) return judge::outside("no impulse: the bodies need not touch");
  const Vec3 out = (at.ball_is_a() ? -1.0 : 1.0) * at.asked.radius() * at.event.nhat_BA_W;
  const double error = off(at.event.p_WC - out, at.asked.exact(at.sample).p_WB);
  const double bound = at.asked.bounds[at.sample].place + tolerance::overlap_of_step(at.asked.scene);
  return judge::at_most(
      error, {bound, 1, "m", at.asked.radius()}, Defect::wrong_witness,
      [&] {
        return "the point of contact is " + words::text(at.event.p_WC) + " at the event at " +
               words::text(at.event.time) + " s";
      },
      [&] { return std::string("a point of the ball in the direction of the normal"); });
}

/// m/s: the greatest jump of the changes that a stepper may see a part of in the step before an event: those that are
/// near, and if it may be on the other side of a change, the one before and the one after.
double jump_beside(const AtEvent& at) {
  const std::vector<Change>& changes = at.asked.truth.changes;
  const double time = at.event.time, near = time_until_settled(at.asked.scene);
  const auto after = std::ranges::find_if(changes, [&](const Change& change) { return change.time.lo > time; });
  double jump = 0;
  for (auto change = changes.begin(); change != changes.end(); ++change) {
    const bool is_next = change == after || change + 1 == after;
    const bool is_near = change->time.lo - near <= time && time <= change->time.hi + near;
    if (is_near || (is_next && !at.asked.bounds[at.sample].settled)) jump = std::max(jump, change->velocity_jump);
  }
  return jump;
}

/// As the exact ball moves then, or as the change beside the event makes it move.
Finding judge_velocity_at(const AtEvent& at) {
  const RollingCase& asked = at.asked;
  const double later = at.event.time + time_until_settled(asked.scene);
  const std::size_t settled = std::min(index_of(asked.scene, later), asked.scene.motion->sample_times.size() - 1);
  if (settled >= asked.bounds.size()) return judge::outside("small errors change the ball's motion");
  return judge_velocity(asked, at.sample, at.ball(), asked.bounds[settled].speed + jump_beside(at));
}

/// The worst finding about the certain events of the ball. The first failure ends the search.
template <class JudgeEvent>
Finding each_event(const Scene& scene, Subject& subject, JudgeEvent&& judge_event) {
  return of_exact_ball(scene, [&](const reference::ConstraintTruth&) {
    return of_steps(scene, subject, [&](const Trajectory& said) {
      if (!said.events) return judge::silent("its events");
      const Scene sampled = sampled_at(scene, *said.events);
      return of_exact_ball(sampled, [&](const reference::ConstraintTruth& truth) {
        const RollingCase asked{
            sampled, subject.card().precision, truth,
            tolerance::rolling(sampled, truth, subject.card().precision, tolerance::granted_step(scene)), said};
        Finding worst = judge::outside("no event of the ball after the start, as long as errors are small");
        for (const Event& event : *said.events) {
          const bool is_about_ball = event.a == truth.ball || event.b == truth.ball;
          const std::size_t sample = index_of(sampled, event.time);
          if (event.kind == Event::Kind::force || !is_about_ball || !(event.time > 0)) continue;
          if (sample >= asked.bounds.size()) break;
          if (worse(worst, judge_event(AtEvent{asked, event, sample}))) return worst;
        }
        return worst;
      });
    });
  });
}

Finding event_states(const Scene& scene, Subject& subject) {
  return each_event(scene, subject, [](const AtEvent& at) {
    Finding finding = judge_place(at.asked, at.sample, at.ball());
    worse(finding, judge_velocity_at(at));
    return finding;
  });
}

Finding event_points(const Scene& scene, Subject& subject) { return each_event(scene, subject, judge_point_at); }

}  // namespace

std::vector<Property> constraint_event_properties() {
  return {
      {"constraint.event_states",
       "constraint",
       {"TS-CONSTRAINT-22"},
       "at an event the ball is where the exact solution has it then, and moves as it or the change beside it",
       event_states},
      {"constraint.event_points",
       "constraint",
       {"TS-CONSTRAINT-22"},
       "where an event presses, its point is on the ball, against the normal",
       event_points},
  };
}

}  // namespace touchstone::properties
