#include "fast/simulation/run.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::simulation {
namespace {

/// The requested frame length, or a longer one so that there are at most 2^13 frames.
double frame_length(const World& world, const SimulationOptions& options) {
  return std::max(options.frame, world.end() * 0x1p-13);
}

bool is_ball_or_block(const BodyMotion& body) { return body.kind() != Kind::other; }

}  // namespace

Run::Run(const Scene& scene, const SimulationOptions& given)
    : options(given),
      world(scene),
      has_closed_forms(std::ranges::all_of(world.bodies(), is_ball_or_block)),
      islands(world),
      rests(world.bodies().size()),
      recorder(world, islands, given.keep_events),
      guard(given, frame_length(world, given), world.end(), world.bodies().size()),
      schedule(world, islands, rests, frame_length(world, given), recorder.statistics(), guard) {
  if (given.exact_momentum) exact_momentum.emplace(world);
}

void Run::advance_to(double time) {
  if (recorder.next_sample() < time) {
    const MarkCounts before = mark_counts;
    recorder.sample_before(time);
    guard.leave_out(marks_since(before));
  }
  world.advance_to(time);
}

void Run::end_frame() {
  if (!stopped()) world.advance_to(schedule.frame_end());
  const MarkCounts before = mark_counts;
  recorder.sample_through(stopped() ? guard.stopped()->time : world.now());
  guard.leave_out(marks_since(before));
}

void Run::stop_before_now(BodyId a, BodyId b, const char* why) {
  guard.stop(std::max(recorder.last_event(), std::nextafter(world.now(), 0.0)), a, b, why);
}

Simulated Run::result() {
  Simulated done = recorder.take(guard.stopped());
  if (exact_momentum) {
    done.momentum_before = exact_momentum->before();
    done.momentum = exact_momentum->now();
  }
  return done;
}

}  // namespace touchstone::fast::simulation
