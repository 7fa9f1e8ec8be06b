#include "fast/simulation/later.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::simulation {
namespace {

constexpr double short_step = 0x1p-6;  // of the longest step: a separating pair hardly returns within it

/// The pair touches within the envelope but separates: from now on it counts as in contact only where the bodies
/// overlap. If the represented trajectories deviate faster than the bodies separate, this cannot be decided, so steps
/// get shorter until another contact point that comes down is found in time. If no step is short enough, or if the pair
/// can touch at one point only, it is not queried within the step.
void defer_separating_pair(Run& run, BodyId a, BodyId b) {
  const bool is_point = has_closed_form(run.world.body(a), run.world.body(b));
  bool shorter = false;
  for (const BodyId id : {a, b}) {
    Island* island = run.islands.of(id);
    if (island && island->shorten(is_point ? short_step : shortest_step)) shorter = true;
  }
  PairMemory& memory = run.schedule.memory(a, b);
  memory.separating_at = run.world.now();
  memory.impacts = run.world.impacts(a, b);
  if (is_point || !shorter) memory.not_queried_at = run.world.now();
}

/// When two bodies that touch at one point at most will touch, if their velocities stay (s from now).
double time_to_contact(Run& run, BodyId a, BodyId b) {
  const BodyMotion &A = run.world.body(a), &B = run.world.body(b);
  if (!has_closed_form(A, B)) return never;
  const Touch touch = run.schedule.nearest_points(a, b, run.world.now());
  const double u_n = normal_velocity(A, run.islands.state(a), B, run.islands.state(b), touch);
  return u_n < 0 && touch.gap > 0 ? touch.gap / -u_n : never;
}

bool is_convex(const BodyMotion& body) { return body.kind() != Kind::other || body.model().solid.parts().size() == 1; }

/// A time (s) within which two bodies that touch cannot approach by more than a part of `within` (m). Two convex bodies
/// have a separating plane, so that, apart from rotation, only motion along its normal brings them closer. If one
/// slides on the other and no force presses them together, they never approach.
double time_apart(const BodyMotion& a, const BodyMotion& b, const Vec3& nhat_BA_W, double now, double within) {
  const Vec3 u = a.path().velocity(now) - b.path().velocity(now), du_dt = a.path().a - b.path().a;
  const bool is_plane_between = is_convex(a) && is_convex(b);
  double speed = is_plane_between ? std::max(-nhat_BA_W.dot(u), 0.0) : u.lpNorm<1>();
  double acceleration = is_plane_between ? std::max(-nhat_BA_W.dot(du_dt), 0.0) : du_dt.lpNorm<1>();
  for (const BodyMotion* body : {&a, &b}) {
    if (body->fixed() || body->kind() != Kind::other) continue;
    speed += body->ballistic().rate() * body->radius();
    acceleration += body->ballistic().acceleration_per_radius() * body->radius();
  }
  const double near = within / 16, sum = speed + std::sqrt(speed * speed + 2 * acceleration * near);
  return sum > 0 ? 2 * near / sum : never;
}

}  // namespace

void recheck(Run& run, BodyId a, BodyId b) {
  Island *island_a = run.islands.of(a), *island_b = run.islands.of(b);
  if (!island_a && !island_b) return run.schedule.predict(a, b, run.world.now());
  const double expected = time_to_contact(run, a, b);
  for (Island* island : {island_a, island_b}) {
    if (island) island->shorten(shortest_step, expected);
  }
}

void schedule_later(Run& run, BodyId a, BodyId b, const Touch& touch) {
  if (run.islands.of(a) || run.islands.of(b)) return defer_separating_pair(run, a, b);
  const World& world = run.world;
  const BodyMotion &A = world.body(a), &B = world.body(b);
  // A smaller distance than that of rounding cannot be told from none.
  const double within = std::max(world.envelope(), 2 * clearance(A, B, world.now(), never));
  const double step = time_apart(A, B, touch.nhat_BA_W, world.now(), within);
  const double grain = world.now() * 0x1p-51;
  if (step < grain) run.guard.count_lost_resolution();
  run.schedule.predict(a, b, world.now() + std::max(step, grain));
}

}  // namespace touchstone::fast::simulation
