#include "properties/cases/timeline.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/motion_in_doubles.h"
#include "oracle/truth/truth.h"

namespace touchstone::properties {
namespace {

std::size_t index(int body) { return static_cast<std::size_t>(body); }

/// Is the body in ballistic motion after this event? An applied force, and micro-bounces of a contact, do not change
/// that.
bool ballistic_after(Event::Kind kind, bool was_ballistic) {
  if (kind == Event::Kind::impact || kind == Event::Kind::release) return true;
  return kind != Event::Kind::contact && kind != Event::Kind::completed && was_ballistic;
}

void begin(std::vector<Segment>& segments, std::size_t index, const Event& event, const State& after, double end,
           bool fixed) {
  Segment& before = segments.back();
  const bool was_ballistic = before.ballistic;
  before.until = event.time;
  before.ends_with = index;
  // What led to the completion is not reported.
  if (event.kind == Event::Kind::completed) before.ballistic = fixed;
  const std::size_t body = before.body;
  segments.push_back({body, event.time, end, after, fixed || ballistic_after(event.kind, was_ballistic)});
}

double start_time(const Scene& scene, std::size_t body) {
  return scene.motion->start_times.empty() ? 0 : scene.motion->start_times[body];
}

bool two_overlap_at_start(const Scene& scene, std::size_t i, std::size_t j) {
  const Body &a = scene.bodies[i], &b = scene.bodies[j];
  if (is_fixed(a) && is_fixed(b)) return false;
  const double start = std::max(start_time(scene, i), start_time(scene, j));
  const auto segment = [&](std::size_t k, const Body& body) {
    return Segment{k, start_time(scene, k), start, {body.X_WB, body.velocity}};
  };
  const Scene pair = oracle::pair_at(segment_scene(scene, {segment(i, a), segment(j, b)}, start), start);
  const double reach = oracle::tolerance::radius(a) + oracle::tolerance::radius(b);
  if ((pair.bodies[0].X_WB.p_WB - pair.bodies[1].X_WB.p_WB).norm() > 1.01 * reach) return false;
  return oracle::truth::distance(pair).verdict == Verdict::overlapping;
}

bool any_overlap_at_start(const Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.bodies.size(); ++j) {
      if (two_overlap_at_start(scene, i, j)) return true;
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

double complete_until(const Scene& scene, const Trajectory& trajectory) {
  return trajectory.complete_until.value_or(scene.motion->sample_times.back());
}

Trajectory reported_before(const Scene& scene, Trajectory said, double time) {
  const std::vector<double>& times = scene.motion->sample_times;
  const auto samples = static_cast<std::size_t>(std::ranges::lower_bound(times, time) - times.begin());
  if (said.states.size() > samples) said.states.resize(samples);
  if (said.events) std::erase_if(*said.events, [time](const Event& event) { return event.time >= time; });
  if (said.complete_until && *said.complete_until >= time) {
    said.complete_until.reset();
    said.gave_up.clear();
  }
  said.contact_solver.reset();
  return said;
}

Timeline timeline(const Scene& scene, const Trajectory& trajectory) {
  const double end = complete_until(scene, trajectory);
  Timeline segments(scene.bodies.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Body& body = scene.bodies[i];
    segments[i].push_back({i, start_time(scene, i), end, {body.X_WB, body.velocity}, true});
  }
  for (std::size_t e = 0; e < trajectory.events->size(); ++e) {
    const Event& event = (*trajectory.events)[e];
    begin(segments[index(event.a)], e, event, event.after_a, end, is_fixed(scene.bodies[index(event.a)]));
    if (event.b >= 0)
      begin(segments[index(event.b)], e, event, event.after_b, end, is_fixed(scene.bodies[index(event.b)]));
  }
  return segments;
}

std::vector<Segment> segments_into(const Timeline& timeline, const Trajectory& trajectory, std::size_t event) {
  const Event& end = (*trajectory.events)[event];
  std::vector<Segment> segments;
  for (const int body : {end.a, end.b}) {
    if (body >= 0) segments.push_back(*std::ranges::lower_bound(timeline[index(body)], event, {}, &Segment::ends_with));
  }
  return segments;
}

Scene segment_scene(const Scene& scene, const std::vector<Segment>& segments, double until) {
  Scene few;
  few.gravity = scene.gravity;
  few.motion.emplace();
  few.motion->sample_times = {until};
  few.motion->law = scene.motion->law;
  few.motion->force_bound = scene.motion->force_bound;
  for (const Segment& segment : segments) {
    Body body = scene.bodies[segment.body];
    body.name.clear();
    body.X_WB = segment.start.X_WB;
    body.velocity = segment.start.velocity;
    few.bodies.push_back(std::move(body));
    few.motion->start_times.push_back(segment.from);
  }
  for (AppliedForce applied : scene.motion->forces) {
    const auto segment = std::ranges::find(segments, index(applied.body), &Segment::body);
    if (segment == segments.end() || applied.time > segment->from) continue;
    applied.body = static_cast<int>(segment - segments.begin());
    few.motion->forces.push_back(applied);
  }
  return few;
}

}  // namespace touchstone::properties
