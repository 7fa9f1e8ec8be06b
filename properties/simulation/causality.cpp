// The clauses of docs/spec/simulation.md about what may determine a trajectory: no applied force before its time, and
// of the past nothing but the present states.
#include <algorithm>
#include <cmath>
#include <set>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Outcome;
using oracle::Subject;
using Status = TimeOfImpact::Status;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace words = oracle::words;

/// The scene with the opposite forces from `time` on. Their times stay, so that a stepping engine takes the same steps.
Scene opposed_from(Scene scene, double time) {
  for (AppliedForce& applied : scene.motion->forces) {
    if (applied.time >= time) applied.force_W = -applied.force_W;
  }
  return scene;
}

bool is_empty(const Trajectory& said) { return said.states.empty() && (!said.events || said.events->empty()); }

// In advance a subject knows the times of forces and the bound of their strength, but not the forces.
Finding no_foresight(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    std::set<double> times;
    for (const AppliedForce& applied : scene.motion->forces) {
      if (!applied.force_W.isZero(0)) times.insert(applied.time);
    }
    Finding finding = judge::outside("nothing is reported before an applied force");
    for (const double time : times) {
      const Trajectory expected = reported_before(scene, asked.said, time);
      if (is_empty(expected)) continue;
      finding = judge::given(subject.simulation(opposed_from(scene, time)), [&](const Trajectory& said) {
        if (reported_before(scene, said, time) == expected) return judge::holds();
        return judge::wrong(Defect::inconsistent,
                            "another trajectory before a force of opposite direction at " + words::text(time) + " s",
                            "the same bits before the force");
      });
      if (finding.outcome != Outcome::holds) return finding;
    }
    return finding;
  });
}

/// The motion from sample `sample` on, from the states that the subject reports there.
Scene continued(Scene scene, const TrajectoryCase& asked, std::size_t sample) {
  const double time = asked.time(sample);
  const std::vector<State>& states = asked.said.states[sample];
  for (std::size_t i = 0; i < states.size(); ++i) {
    scene.bodies[i].X_WB = states[i].X_WB;
    scene.bodies[i].velocity = states[i].velocity;
  }
  scene.motion->start_times.assign(states.size(), time);
  std::erase_if(scene.motion->sample_times, [time](double t) { return t <= time; });
  return scene;
}

/// The segments within which all bodies are in ballistic motion at `time`; empty if one is not, or has an event there.
std::vector<Segment> segments_at(const Timeline& timeline, double time) {
  std::vector<Segment> there;
  for (const std::vector<Segment>& segments : timeline) {
    const auto now =
        std::ranges::find_if(segments, [time](const Segment& s) { return s.from < time && time < s.until; });
    if (now == segments.end() || !now->ballistic) return {};
    there.push_back(*now);
  }
  return there;
}

/// A trajectory, and the one that starts from a sample of it.
struct Continued {
  const TrajectoryCase& asked;
  const std::vector<Segment>& segments;  ///< of each body, at the sample
  const TrajectoryCase& again;
  double time;  ///< s: of the sample

  /// m: how far apart the two may be at `until`, from where only ballistic motion leads: the errors of both, and what
  /// becomes of the error of the state from which the second one starts.
  double apart(std::size_t body, double until) const {
    const Scene first = segment_scene(asked.scene, {segments[body]}, until);
    const Scene second = segment_scene(again.scene, {Segment{body, time, until, start(body)}}, until);
    return allowance(first, 0, until, asked.precision).place + allowance(second, 0, until, asked.precision).place +
           tolerance::carried(first, 0, time, until, allowance(first, 0, time, asked.precision));
  }
  State start(std::size_t body) const { return {again.scene.bodies[body].X_WB, again.scene.bodies[body].velocity}; }
};

bool has_event(const TrajectoryCase& asked, std::size_t body, double from, double until) {
  const auto index = static_cast<int>(body);
  return std::ranges::any_of(*asked.said.events, [&](const Event& event) {
    return (event.a == index || event.b == index) && event.time > from && event.time <= until;
  });
}

// The poses at the next sample of the bodies that have no event until then.
Finding same_poses(const Continued& both, std::size_t sample) {
  Finding worst = judge::outside("each body has an event before the next sample");
  if (sample + 1 >= both.asked.samples() || both.again.samples() == 0) return worst;
  const double until = both.asked.time(sample + 1);
  for (std::size_t i = 0; i < both.segments.size(); ++i) {
    if (has_event(both.asked, i, both.time, until) || has_event(both.again, i, both.time, until)) continue;
    const Body& body = both.asked.scene.bodies[i];
    const Pose &X = both.asked.said.states[sample + 1][i].X_WB, &Y = both.again.said.states[0][i].X_WB;
    const double allowed = both.apart(i, until);
    if (worse(worst, counted(is_decisive(body, allowed),
                             judge::at_most(
                                 displacement(body, Y, X), in_ulps_of_place(both.asked, allowed), Defect::inconsistent,
                                 [&] { return words::text(Y.p_WB) + " at " + words::text(until) + " s"; },
                                 [&] { return words::text(X.p_WB) + ", without a new start"; })))) {
      return worst;
    }
  }
  return worst;
}

bool same_pair(const Event& a, const Event& b) { return a.a == b.a && a.b == b.b; }

// The first impact after the sample keeps its time to within the window that rounding and the envelope permit.
Finding same_impact(const Continued& both) {
  const std::vector<Event>& events = *both.asked.said.events;
  const auto first = std::ranges::find_if(events, [&](const Event& event) { return event.time > both.time; });
  if (first == events.end() || first->kind != Event::Kind::impact) return judge::outside("no impact after the sample");
  const auto a = static_cast<std::size_t>(first->a), b = static_cast<std::size_t>(first->b);
  const double end = both.asked.end;
  const Scene pair_scene = segment_scene(both.asked.scene, {both.segments[a], both.segments[b]}, end);
  std::optional<MotionCase> pair = motion_case(pair_scene, both.asked.precision);
  if (!pair) return judge::outside("the pair overlaps where its segments begin");
  pair->slack += both.apart(a, first->time) + both.apart(b, first->time);
  if (!pair->sure()) return judge::outside(too_far_to_decide);
  const auto near = oracle::truth::time_of_distance(pair_scene, envelope(both.asked.scene) + pair->slack);
  const std::optional<double> latest = pair->latest();
  if (near.status != Status::hit || !latest) return judge::outside("the bodies graze: rounding decides");
  const double window = *latest - near.time.lo;
  const std::vector<Event>& again = *both.again.said.events;
  if (again.empty()) {
    if (both.again.end < *latest) return judge::outside("the new run ends before the impact");
    return judge::wrong(Defect::missed, "no impact from " + words::text(both.time) + " s on", text(*first));
  }
  const Event& second = again.front();
  if (!same_pair(second, *first) && second.time <= *latest) return judge::outside("another pair may come first");
  return judge::at_most(
      std::abs(second.time - first->time), {window, std::max(window, 0x1p-1000), "windows of the impact"},
      second.time < first->time ? Defect::too_early : Defect::too_late,
      [&] { return text(second) + ", from " + words::text(both.time) + " s on"; },
      [&] { return text(*first) + ", without a new start"; });
}

Finding continues(const TrajectoryCase& asked, const std::vector<Segment>& segments, std::size_t sample,
                  Subject& subject) {
  const Scene scene = continued(asked.scene, asked, sample);
  if (overlap_at_start(scene)) return judge::outside("bodies that overlap by rounding at the sample");
  return of_timeline(scene, subject, [&](const TrajectoryCase& again, const Timeline&) {
    const Continued both{asked, segments, again, asked.time(sample)};
    Finding worst = same_poses(both, sample);
    if (worst.outcome != Outcome::fails) worse(worst, same_impact(both));
    return worst;
  });
}

// Where no body is in contact, the states at one time determine all that follows.
Finding resumed(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = judge::outside("no sample at which all bodies are in ballistic motion");
    for (std::size_t sample = 0; sample + 1 < scene.motion->sample_times.size() && sample < asked.samples(); ++sample) {
      const std::vector<Segment> segments = segments_at(timeline, asked.time(sample));
      if (segments.empty()) continue;
      if (worse(worst, continues(asked, segments, sample, subject))) return worst;
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_causality_properties() {
  const std::string query = "simulation", clause = "TS-SIMULATION-";
  return {
      {"simulation.no_foresight",
       query,
       {clause + "24"},
       "before its time an applied force changes nothing",
       no_foresight},
      {"simulation.resumed",
       query,
       {clause + "27"},
       "a run that starts from the states of a sample continues as the whole run does",
       resumed},
  };
}

}  // namespace touchstone::properties
