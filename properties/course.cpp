#include "properties/course.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "oracle/flown.h"
#include "oracle/tolerance.h"
#include "oracle/truth.h"

namespace touchstone::properties {
namespace {

bool is_fixed(const Body& body) { return std::holds_alternative<Fixed>(body.mass); }

std::size_t index(int body) { return static_cast<std::size_t>(body); }

/// Is the body in flight once this has happened to it? A push, and hops of a contact, leave that as it was.
bool flies_after(Event::Kind kind, bool flew) {
  if (kind == Event::Kind::impact || kind == Event::Kind::release) return true;
  return kind != Event::Kind::contact && kind != Event::Kind::completed && flew;
}

void begin(std::vector<Leg>& legs, std::size_t index, const Event& event, const State& after, double end, bool fixed) {
  Leg& before = legs.back();
  const bool flew = before.flies;
  before.until = event.time;
  before.ends_with = index;
  // What led up to the completion is not told.
  if (event.kind == Event::Kind::completed) before.flies = fixed;
  const std::size_t body = before.body;
  legs.push_back({body, event.time, end, after, fixed || flies_after(event.kind, flew)});
}

double since(const Scene& scene, std::size_t body) {
  return scene.flight->since.empty() ? 0 : scene.flight->since[body];
}

bool overlap_at_start(const Scene& scene, std::size_t i, std::size_t j) {
  const Body &a = scene.bodies[i], &b = scene.bodies[j];
  if (is_fixed(a) && is_fixed(b)) return false;
  const double start = std::max(since(scene, i), since(scene, j));
  const auto leg = [&](std::size_t k, const Body& body) {
    return Leg{k, since(scene, k), start, {body.X_WB, body.velocity}};
  };
  const Scene pair = oracle::pair_at(in_flight(scene, {leg(i, a), leg(j, b)}, start), start);
  const double reach = oracle::tolerance::radius(a) + oracle::tolerance::radius(b);
  if ((pair.bodies[0].X_WB.p_WB - pair.bodies[1].X_WB.p_WB).norm() > 1.01 * reach) return false;
  return oracle::truth::distance(pair).verdict == Verdict::overlapping;
}

bool any_overlap_at_start(const Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.bodies.size(); ++j) {
      if (overlap_at_start(scene, i, j)) return true;
    }
  }
  return false;
}

}  // namespace

bool overlap_at_start(const Scene& scene) {
  thread_local std::optional<std::pair<Scene, bool>> last;
  if (!last || !(last->first == scene)) last.emplace(scene, any_overlap_at_start(scene));
  return last->second;
}

double whole_until(const Scene& scene, const Trajectory& trajectory) {
  return trajectory.complete_until.value_or(scene.flight->times.back());
}

Course course(const Scene& scene, const Trajectory& trajectory) {
  const double end = whole_until(scene, trajectory);
  Course legs(scene.bodies.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Body& body = scene.bodies[i];
    legs[i].push_back({i, since(scene, i), end, {body.X_WB, body.velocity}, true});
  }
  for (std::size_t e = 0; e < trajectory.events->size(); ++e) {
    const Event& event = (*trajectory.events)[e];
    begin(legs[index(event.a)], e, event, event.after_a, end, is_fixed(scene.bodies[index(event.a)]));
    if (event.b >= 0) begin(legs[index(event.b)], e, event, event.after_b, end, is_fixed(scene.bodies[index(event.b)]));
  }
  return legs;
}

std::vector<Leg> legs_into(const Course& course, const Trajectory& trajectory, std::size_t event) {
  const Event& end = (*trajectory.events)[event];
  std::vector<Leg> legs;
  for (const int body : {end.a, end.b}) {
    if (body >= 0) legs.push_back(*std::ranges::lower_bound(course[index(body)], event, {}, &Leg::ends_with));
  }
  return legs;
}

Scene in_flight(const Scene& scene, const std::vector<Leg>& legs, double until) {
  Scene few;
  few.gravity = scene.gravity;
  few.flight.emplace();
  few.flight->times = {until};
  few.flight->law = scene.flight->law;
  few.flight->force_bound = scene.flight->force_bound;
  for (const Leg& leg : legs) {
    Body body = scene.bodies[leg.body];
    body.name.clear();
    body.X_WB = leg.start.X_WB;
    body.velocity = leg.start.velocity;
    few.bodies.push_back(std::move(body));
    few.flight->since.push_back(leg.from);
  }
  for (Push push : scene.flight->pushes) {
    const auto leg = std::ranges::find(legs, index(push.body), &Leg::body);
    if (leg == legs.end() || push.time > leg->from) continue;
    push.body = static_cast<int>(leg - legs.begin());
    few.flight->pushes.push_back(push);
  }
  return few;
}

}  // namespace touchstone::properties
