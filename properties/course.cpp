#include "properties/course.h"

#include <algorithm>

namespace touchstone::properties {
namespace {

bool is_fixed(const Body& body) { return std::holds_alternative<Fixed>(body.mass); }

std::size_t index(int body) { return static_cast<std::size_t>(body); }

/// Is the body in flight once this has happened to it? A push, and hops of a contact, leave that as it was.
bool flies_after(Event::Kind kind, bool flew) {
  if (kind == Event::Kind::impact || kind == Event::Kind::release) return true;
  return kind != Event::Kind::contact && kind != Event::Kind::completed && flew;
}

void begin(std::vector<Leg>& legs, const Event& event, const State& after, double end, bool fixed) {
  Leg& before = legs.back();
  const bool flew = before.flies;
  before.until = event.time;
  // What led up to the completion is not told.
  if (event.kind == Event::Kind::completed) before.flies = fixed;
  const std::size_t body = before.body;
  legs.push_back({body, event.time, end, after, fixed || flies_after(event.kind, flew)});
}

bool is_of(const Event& event, int body) { return event.a == body || event.b == body; }

}  // namespace

double whole_until(const Scene& scene, const Trajectory& trajectory) {
  return trajectory.complete_until.value_or(scene.flight->times.back());
}

Course course(const Scene& scene, const Trajectory& trajectory) {
  const double end = whole_until(scene, trajectory);
  Course legs(scene.bodies.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Body& body = scene.bodies[i];
    const double since = scene.flight->since.empty() ? 0 : scene.flight->since[i];
    legs[i].push_back({i, since, end, {body.X_WB, body.velocity}, true});
  }
  for (const Event& event : *trajectory.events) {
    begin(legs[index(event.a)], event, event.after_a, end, is_fixed(scene.bodies[index(event.a)]));
    if (event.b >= 0) begin(legs[index(event.b)], event, event.after_b, end, is_fixed(scene.bodies[index(event.b)]));
  }
  return legs;
}

std::vector<Leg> legs_into(const Course& course, const Trajectory& trajectory, std::size_t event) {
  const std::vector<Event>& events = *trajectory.events;
  std::vector<Leg> legs;
  for (const int body : {events[event].a, events[event].b}) {
    if (body < 0) continue;
    const auto before = std::count_if(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(event),
                                      [body](const Event& e) { return is_of(e, body); });
    legs.push_back(course[index(body)][static_cast<std::size_t>(before)]);
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
