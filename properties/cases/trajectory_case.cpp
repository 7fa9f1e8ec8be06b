#include "properties/cases/trajectory_case.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/motion_in_doubles.h"
#include "properties/cases/time_of_impact_case.h"

namespace touchstone::properties {
namespace {

namespace tolerance = oracle::tolerance;
namespace words = oracle::words;

const char* name_of(Event::Kind kind) {
  switch (kind) {
    case Event::Kind::impact:
      return "impact";
    case Event::Kind::micro_collision:
      return "micro-collision";
    case Event::Kind::completed:
      return "completed";
    case Event::Kind::contact:
      return "contact";
    case Event::Kind::release:
      return "release";
    case Event::Kind::force:
      return "force";
  }
  return "event";
}

std::string fault_in_event(const Scene& scene, const Event& event, double end) {
  const auto count = static_cast<int>(scene.bodies.size());
  if (event.a < 0 || event.a >= count || event.b >= count) return "a body that does not exist";
  const bool pair = event.kind != Event::Kind::force;
  if (pair != (event.b >= 0) || (pair && event.a >= event.b)) return "not a pair a < b";
  if (event.time < 0 || event.time > end) return "a time beyond the end of the motion";
  const std::vector<double>& starts = scene.motion->start_times;
  for (const int body : {event.a, event.b}) {
    if (body >= 0 && !starts.empty() && event.time < starts[static_cast<std::size_t>(body)])
      return "a time before the body's start";
  }
  return {};
}

bool share_a_body(const Event& a, const Event& b) { return a.a == b.a || a.a == b.b || a.b == b.a || a.b == b.b; }

bool in_pair_order(const Event& a, const Event& b) { return std::tuple(a.a, a.b) <= std::tuple(b.a, b.b); }

// Impacts at one time are in the order of their pairs. The order begins anew with those that earlier ones at that time
// caused: bodies that touch act together, so one of them has a body of an earlier impact, not each.
bool in_order(const std::vector<Event>& events, std::size_t k) {
  const Event& event = events[k];
  if (k == 0) return true;
  const Event& before = events[k - 1];
  if (before.time != event.time) return before.time < event.time;
  if (before.kind != Event::Kind::impact || event.kind != Event::Kind::impact) return true;
  if (in_pair_order(before, event)) return true;
  const auto caused = [&](const Event& impact) {
    for (std::size_t i = k; i-- > 0 && events[i].time == event.time;) {
      if (share_a_body(events[i], impact)) return true;
    }
    return false;
  };
  for (std::size_t i = k; i < events.size() && events[i].time == event.time; ++i) {
    if (i > k && !in_pair_order(events[i - 1], events[i])) return false;
    if (caused(events[i])) return true;
  }
  return false;
}

bool reports(const Event& event, const AppliedForce& applied) {
  return event.kind == Event::Kind::force && event.a == applied.body && event.time == applied.time;
}

/// Does the force begin after its body's start? One that acts from the start belongs to the initial conditions.
bool begins_after_start(const AppliedForce& applied, const Motion& motion) {
  return applied.time > (motion.start_times.empty() ? 0 : motion.start_times[static_cast<std::size_t>(applied.body)]);
}

std::string fault_in_forces(const Motion& motion, const std::vector<Event>& events, double end) {
  for (const AppliedForce& applied : motion.forces) {
    const bool reported = std::ranges::any_of(events, [&](const Event& event) { return reports(event, applied); });
    if (begins_after_start(applied, motion) && applied.time < end && !reported) {
      return "a change of an applied force is not reported, at " + words::text(applied.time) + " s";
    }
  }
  for (const Event& event : events) {
    const bool there = std::ranges::any_of(motion.forces, [&](const AppliedForce& applied) {
      return reports(event, applied) && begins_after_start(applied, motion);
    });
    if (event.kind == Event::Kind::force && !there)
      return "an event without a change of an applied force: " + text(event);
  }
  return {};
}

/// The allowance, and what the stepping that the subject declares adds to it.
tolerance::BallisticBound granted(const TrajectoryCase& asked, const Scene& ballistic_scene, std::size_t k,
                                  double time) {
  tolerance::BallisticBound bound = allowance(ballistic_scene, k, time, asked.precision);
  if (!asked.stepping) return bound;
  const tolerance::BallisticBound steps =
      tolerance::stepped(ballistic_scene, k, time, *asked.stepping, asked.precision);
  bound.place += steps.place;
  bound.velocity += steps.velocity;
  bound.spin += steps.spin;
  return bound;
}

/// Where the reference gives up (reference/ballistic_motion.h).
bool is_known(const State& state) { return std::isfinite(state.X_WB.q_WB.w); }

oracle::Finding unknown() { return oracle::judge::outside("the reference does not know this motion"); }

// Angular velocities count times the radius.
oracle::Finding moves(const TrajectoryCase& asked, const Scene& ballistic_scene, std::size_t k, double time,
                      const Velocity& said) {
  const State state = oracle::ballistic_state(ballistic_scene, k, time);
  if (!is_known(state)) return unknown();
  const Velocity& expected = state.velocity;
  const tolerance::BallisticBound allowed = granted(asked, ballistic_scene, k, time);
  const double radius = tolerance::radius(ballistic_scene.bodies[k]);
  const double off = (said.v_WBcm - expected.v_WBcm).norm() + radius * (said.w_WB - expected.w_WB).norm();
  const double speed = std::max(allowed.fastest, 0x1p-900), unit = oracle::unit_roundoff(asked.precision) * speed;
  const auto velocity_text = [](const Velocity& V) {
    return "v = " + words::text(V.v_WBcm) + ", w = " + words::text(V.w_WB);
  };
  return oracle::judge::at_most(
      off, {allowed.velocity + radius * allowed.spin, unit, "ulps of its speed", 0, speed},
      oracle::Defect::wrong_motion, [&] { return velocity_text(said); }, [&] { return velocity_text(expected); });
}

std::string pose_text(const Pose& pose) {
  const Quaternion& q = pose.q_WB;
  return "p = " + words::text(pose.p_WB) + ", q = (" + words::text(q.w) + ", " + words::text(q.x) + ", " +
         words::text(q.y) + ", " + words::text(q.z) + ")";
}

}  // namespace

std::vector<State> first_states(const Scene& scene) {
  std::vector<State> states;
  for (const Body& body : scene.bodies) states.push_back({body.X_WB, body.velocity});
  return states;
}

bool fixed_bodies_rest(const Scene& scene) {
  return std::ranges::all_of(scene.bodies,
                             [](const Body& body) { return !is_fixed(body) || body.velocity == Velocity{}; });
}

Scene posed_pair(const Scene& scene, std::size_t i, const Pose& X_Wi, std::size_t k, const Pose& X_Wk) {
  Scene pair;
  pair.bodies = {scene.bodies[i], scene.bodies[k]};
  pair.bodies[0].X_WB = X_Wi;
  pair.bodies[1].X_WB = X_Wk;
  return pair;
}

double displacement(const Body& body, const Pose& said, const Pose& expected) {
  const oracle::Real shift = (said.p_WB.cast<oracle::Real>() - expected.p_WB.cast<oracle::Real>()).norm();
  const oracle::Real turned = (oracle::rotation_matrix(said.q_WB) - oracle::rotation_matrix(expected.q_WB)).norm();
  return static_cast<double>(shift + turned * tolerance::radius(body));
}

tolerance::BallisticBound allowance(const Scene& ballistic_scene, std::size_t k, double time,
                                    oracle::Precision precision) {
  tolerance::BallisticBound allowed = tolerance::ballistic(ballistic_scene, k, time, precision);
  const tolerance::BallisticBound own = tolerance::rounded_state(ballistic_scene, k, time, oracle::Precision::exact);
  const double roundings = 4 + std::ldexp(oracle::unit_roundoff(precision), 53);
  allowed.place += roundings * own.place;
  allowed.velocity += roundings * own.velocity;
  allowed.spin += roundings * own.spin;
  return allowed;
}

oracle::Finding check_pose(const TrajectoryCase& asked, const Scene& ballistic_scene, std::size_t k, double time,
                           const Pose& said) {
  const Body& body = ballistic_scene.bodies[k];
  const State state = oracle::ballistic_state(ballistic_scene, k, time);
  if (!is_known(state)) return unknown();
  const Pose& expected = state.X_WB;
  const double rounding = allowance(ballistic_scene, k, time, asked.precision).place;
  const double allowed = granted(asked, ballistic_scene, k, time).place;
  const bool decisive = is_decisive(body, rounding) && allowed < tolerance::size(body);
  return counted(decisive,
                 oracle::judge::at_most(
                     displacement(body, said, expected), in_ulps_of_place(asked, allowed), oracle::Defect::wrong_motion,
                     [&] { return pose_text(said); }, [&] { return pose_text(expected); }));
}

oracle::Finding check_state(const TrajectoryCase& asked, const Scene& ballistic_scene, std::size_t k, double time,
                            const State& said) {
  oracle::Finding worst = check_pose(asked, ballistic_scene, k, time, said.X_WB);
  if (worst.outcome == oracle::Outcome::holds) worse(worst, moves(asked, ballistic_scene, k, time, said.velocity));
  return worst;
}

std::string fault_in_form(const Scene& scene, const Trajectory& said) {
  const std::vector<double>& times = scene.motion->sample_times;
  const double end = complete_until(scene, said);
  const auto whole = std::ranges::count_if(times, [end](double t) { return t <= end; });
  if (said.states.size() != static_cast<std::size_t>(whole))
    return "not one entry of states per sample time up to complete_until";
  for (const std::vector<State>& states : said.states) {
    if (states.size() != scene.bodies.size()) return "not one state per body";
  }
  if (!said.events) return {};
  for (std::size_t k = 0; k < said.events->size(); ++k) {
    const Event& event = (*said.events)[k];
    if (const std::string fault = fault_in_event(scene, event, end); !fault.empty()) return fault + ": " + text(event);
    if (!in_order(*said.events, k)) return "not in the order of (time, a, b): " + text(event);
  }
  return fault_in_forces(*scene.motion, *said.events, end);
}

bool worse(oracle::Finding& worst, oracle::Finding next) {
  const auto excess = [](const oracle::Finding& f) { return f.allowed > 0 ? f.error / f.allowed : f.error; };
  const bool failed = next.outcome == oracle::Outcome::fails, judged = next.outcome != oracle::Outcome::outside;
  if (worst.outcome == oracle::Outcome::outside || (judged && (failed || excess(next) > excess(worst)))) {
    worst = std::move(next);
  }
  return failed;
}

oracle::judge::Allowance in_ulps_of_place(const TrajectoryCase& asked, double bound) {
  oracle::Card card;
  card.precision = asked.precision;
  oracle::judge::Allowance allowance = oracle::judge::in_ulps(asked.scene, card, bound);
  allowance.value = tolerance::longest_way(asked.scene, end_of(asked.scene));
  return allowance;
}

std::string text(const Event& event) {
  std::string all =
      std::string(name_of(event.kind)) + " at " + words::text(event.time) + " s of body " + std::to_string(event.a);
  if (event.b >= 0) all += " and " + std::to_string(event.b);
  return all;
}

}  // namespace touchstone::properties
