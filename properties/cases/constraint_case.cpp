#include "properties/cases/constraint_case.h"

#include <algorithm>

#include "oracle/judge/words.h"
#include "properties/cases/timeline.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::words::text;
namespace judge = oracle::judge;

std::string text_of(const std::array<Interval, 3>& v) {
  return text(Vec3(v[0].middle(), v[1].middle(), v[2].middle()));
}

/// m/s: of the ball, the exact one of its centre or of its surface about it, whichever is greater.
double speed(const RollingCase& asked, std::size_t sample) {
  const reference::BallTruth& exact = asked.exact(sample);
  return std::max(off(Vec3::Zero(), exact.v_WB), asked.radius() * off(Vec3::Zero(), exact.w_WB));
}

std::string at(const RollingCase& asked, std::size_t sample) {
  return " at " + text(asked.scene.motion->sample_times[sample]) + " s";
}

}  // namespace

std::string fault_of_steps(const Scene& scene, const Trajectory& said) {
  const std::vector<double>& times = scene.motion->sample_times;
  const double end = complete_until(scene, said);
  const auto whole = static_cast<std::size_t>(std::ranges::upper_bound(times, end) - times.begin());
  if (said.states.size() != whole) return "not one entry of states per sample time";
  for (const std::vector<State>& bodies : said.states) {
    if (bodies.size() != scene.bodies.size()) return "not one state per body";
  }
  double last = 0;
  const int count = static_cast<int>(scene.bodies.size());
  for (const Event& event : said.events.value_or(std::vector<Event>{})) {
    if (event.time < last) return "events that are not in the order of time";
    if (event.time > std::min(end, times.back())) return "an event after the run's end";
    last = event.time;
    const bool is_force = event.kind == Event::Kind::force;
    if (is_force && event.a >= 0 && event.a < count && event.b < 0) continue;
    if (is_force || event.a < 0 || event.b <= event.a || event.b >= count) return "an event without a pair a < b";
  }
  return "";
}

double RollingCase::radius() const {
  return std::get<Sphere>(scene.bodies[static_cast<std::size_t>(truth.ball)].shape).radius;
}

double off(const Vec3& p, const std::array<Interval, 3>& truth) {
  Vec3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = p[static_cast<Eigen::Index>(i)];
    out[static_cast<Eigen::Index>(i)] = std::max({truth[i].lo - x, x - truth[i].hi, 0.0});
  }
  return out.norm();
}

std::set<std::pair<int, int>> in_contact(const std::vector<Event>& events, double time) {
  std::set<std::pair<int, int>> pairs;
  for (const Event& event : events) {
    if (event.time > time) break;
    if (event.kind == Event::Kind::contact) pairs.emplace(event.a, event.b);
    if (event.kind == Event::Kind::release) pairs.erase({event.a, event.b});
  }
  return pairs;
}

Finding judge_place(const RollingCase& asked, std::size_t sample, const State& ball) {
  const Vec3& p = ball.X_WB.p_WB;
  return judge::at_most(
      off(p, asked.exact(sample).p_WB), {asked.bounds[sample].place, 1, "m", asked.radius()}, Defect::wrong_motion,
      [&] { return "the ball's centre is " + text(p) + at(asked, sample); },
      [&] { return text_of(asked.exact(sample).p_WB); });
}

Finding judge_velocity(const RollingCase& asked, std::size_t sample, const State& ball, double bound) {
  const Velocity& V = ball.velocity;
  const reference::BallTruth& exact = asked.exact(sample);
  const double error = std::max(off(V.v_WBcm, exact.v_WB), asked.radius() * off(V.w_WB, exact.w_WB));
  return judge::at_most(
      error, {bound, 1, "m/s", 0, speed(asked, sample)}, Defect::wrong_velocity,
      [&] { return "v = " + text(V.v_WBcm) + ", w = " + text(V.w_WB) + at(asked, sample); },
      [&] { return "v = " + text_of(exact.v_WB) + ", w = " + text_of(exact.w_WB); });
}

Finding judge_place(const RollingCase& asked, std::size_t sample) {
  return judge_place(asked, sample, asked.ball(sample));
}

Finding judge_velocity(const RollingCase& asked, std::size_t sample) {
  return judge_velocity(asked, sample, asked.ball(sample), asked.bounds[sample].speed);
}

}  // namespace touchstone::properties
