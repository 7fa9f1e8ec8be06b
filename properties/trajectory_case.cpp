#include "properties/trajectory_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "oracle/flown.h"
#include "oracle/precision.h"
#include "oracle/tolerance.h"
#include "oracle/tolerance_motion.h"
#include "oracle/words.h"
#include "oracle/world_points.h"
#include "properties/flight_case.h"

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
    case Event::Kind::push:
      return "push";
  }
  return "event";
}

std::string fault_in_event(const Scene& scene, const Event& event, double end) {
  const auto count = static_cast<int>(scene.bodies.size());
  if (event.a < 0 || event.a >= count || event.b >= count) return "a body that is not there";
  const bool pair = event.kind != Event::Kind::push;
  if (pair != (event.b >= 0) || (pair && event.a >= event.b)) return "a pair that is none, or not in order";
  if (event.time < 0 || event.time > end) return "a time beyond the flight";
  return {};
}

bool share_a_body(const Event& a, const Event& b) { return a.a == b.a || a.a == b.b || a.b == b.a || a.b == b.b; }

// At one time impacts come in the order of their pairs, but for one that an impact at that time has brought about.
bool in_order(const std::vector<Event>& events, std::size_t k) {
  const Event& event = events[k];
  if (k == 0) return true;
  const Event& before = events[k - 1];
  if (before.time != event.time) return before.time < event.time;
  if (before.kind != Event::Kind::impact || event.kind != Event::Kind::impact) return true;
  if (std::tuple(before.a, before.b) <= std::tuple(event.a, event.b)) return true;
  for (std::size_t i = k; i-- > 0 && events[i].time == event.time;) {
    if (share_a_body(events[i], event)) return true;
  }
  return false;
}

bool tells_of(const Event& event, const Push& push) {
  return event.kind == Event::Kind::push && event.a == push.body && event.time == push.time;
}

/// On its body's way: one that acts from the start is part of the question.
bool comes_on_the_way(const Push& push, const Flight& flight) {
  return push.time > (flight.since.empty() ? 0 : flight.since[static_cast<std::size_t>(push.body)]);
}

std::string fault_in_pushes(const Flight& flight, const std::vector<Event>& events, double end) {
  for (const Push& push : flight.pushes) {
    const bool told = std::ranges::any_of(events, [&](const Event& event) { return tells_of(event, push); });
    if (comes_on_the_way(push, flight) && push.time < end && !told) {
      return "a push that is not told, at " + words::text(push.time) + " s";
    }
  }
  for (const Event& event : events) {
    const bool there = std::ranges::any_of(
        flight.pushes, [&](const Push& push) { return tells_of(event, push) && comes_on_the_way(push, flight); });
    if (event.kind == Event::Kind::push && !there) return "a push that does not come on the way: " + text(event);
  }
  return {};
}

// m: how far the points of a body are from where they should be, at most.
double displacement(const Body& body, const Pose& said, const Pose& expected) {
  const auto turn = [](const Quaternion& q) {
    return Eigen::Quaternion<oracle::Real>(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  };
  const oracle::Real shift = (said.p_WB.cast<oracle::Real>() - expected.p_WB.cast<oracle::Real>()).norm();
  const oracle::Real turned = (turn(said.q_WB) - turn(expected.q_WB)).norm();
  return static_cast<double>(shift + turned * tolerance::radius(body));
}

// Besides the flight's own bound: one rounding of the answer, and four for the judge's expectation.
tolerance::FlightBound allowance(const Scene& flying, std::size_t k, double time, oracle::Precision precision) {
  tolerance::FlightBound allowed = tolerance::flight(flying, k, time, precision);
  const tolerance::FlightBound own = tolerance::flight(flying, k, time, oracle::Precision::exact);
  const double roundings = 4 + std::ldexp(oracle::unit_roundoff(precision), 53);
  allowed.place += roundings * own.place;
  allowed.velocity += roundings * own.velocity;
  allowed.spin += roundings * own.spin;
  return allowed;
}

// Spins count by the radius.
oracle::Finding moves(const TrajectoryCase& asked, const Scene& flying, std::size_t k, double time,
                      const Velocity& said) {
  const Velocity expected = oracle::flown(flying, k, time).velocity;
  const tolerance::FlightBound allowed = allowance(flying, k, time, asked.precision);
  const double radius = tolerance::radius(flying.bodies[k]);
  const double off = (said.v_WBcm - expected.v_WBcm).norm() + radius * (said.w_WB - expected.w_WB).norm();
  const double unit = oracle::unit_roundoff(asked.precision) * std::max(allowed.fastest, 0x1p-900);
  const auto told = [](const Velocity& V) { return "v = " + words::text(V.v_WBcm) + ", w = " + words::text(V.w_WB); };
  return oracle::judge::at_most(
      off, {allowed.velocity + radius * allowed.spin, unit, "ulps of its speed"}, oracle::Defect::wrong_motion,
      [&] { return told(said); }, [&] { return told(expected); });
}

std::string text(const Pose& pose) {
  const Quaternion& q = pose.q_WB;
  return "p = " + words::text(pose.p_WB) + ", q = (" + words::text(q.w) + ", " + words::text(q.x) + ", " +
         words::text(q.y) + ", " + words::text(q.z) + ")";
}

}  // namespace

oracle::Finding stands(const TrajectoryCase& asked, const Scene& flying, std::size_t k, double time, const Pose& said) {
  const double allowed = allowance(flying, k, time, asked.precision).place;
  const Pose expected = oracle::flown(flying, k, time).X_WB;
  return counted(tells(flying.bodies[k], allowed),
                 oracle::judge::at_most(
                     displacement(flying.bodies[k], said, expected), in_ulps_of_place(asked, allowed),
                     oracle::Defect::wrong_motion, [&] { return text(said); }, [&] { return text(expected); }));
}

oracle::Finding arrives(const TrajectoryCase& asked, const Scene& flying, std::size_t k, double time,
                        const State& said) {
  oracle::Finding worst = stands(asked, flying, k, time, said.X_WB);
  if (worst.outcome == oracle::Outcome::holds) worse(worst, moves(asked, flying, k, time, said.velocity));
  return worst;
}

std::string fault_in_form(const Scene& scene, const Trajectory& said) {
  const std::vector<double>& times = scene.flight->times;
  const double end = whole_until(scene, said);
  const auto whole = std::ranges::count_if(times, [end](double t) { return t <= end; });
  if (said.states.size() != static_cast<std::size_t>(whole)) return "not one entry for each time that is whole";
  for (const std::vector<State>& states : said.states) {
    if (states.size() != scene.bodies.size()) return "not one state for each body";
  }
  if (!said.events) return {};
  for (std::size_t k = 0; k < said.events->size(); ++k) {
    const Event& event = (*said.events)[k];
    if (const std::string fault = fault_in_event(scene, event, end); !fault.empty()) return fault + ": " + text(event);
    if (!in_order(*said.events, k)) return "not in the order of (time, a, b): " + text(event);
  }
  return fault_in_pushes(*scene.flight, *said.events, end);
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
  return oracle::judge::in_ulps(asked.scene, card, bound);
}

std::string text(const Event& event) {
  std::string all =
      std::string(name_of(event.kind)) + " at " + words::text(event.time) + " s of body " + std::to_string(event.a);
  if (event.b >= 0) all += " and " + std::to_string(event.b);
  return all;
}

}  // namespace touchstone::properties
