#include "properties/cases/constraint_case.h"

#include <algorithm>

namespace touchstone::properties {

std::string fault_of_steps(const Scene& scene, const Trajectory& said) {
  const std::vector<double>& times = scene.motion->sample_times;
  const double end = said.complete_until.value_or(times.back());
  const auto whole = static_cast<std::size_t>(std::ranges::upper_bound(times, end) - times.begin());
  if (said.states.size() != whole) return "not one entry of states per sample time";
  for (const std::vector<State>& bodies : said.states) {
    if (bodies.size() != scene.bodies.size()) return "not one state per body";
  }
  double last = 0;
  const int count = static_cast<int>(scene.bodies.size());
  for (const Event& event : said.events.value_or(std::vector<Event>{})) {
    if (event.time < last || event.time > times.back()) return "events that are not in the order of time";
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

Vec3 middle(const std::array<Interval, 3>& truth) {
  const auto of = [](const Interval& x) { return x.lo + (x.hi - x.lo) / 2; };
  return {of(truth[0]), of(truth[1]), of(truth[2])};
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

}  // namespace touchstone::properties
