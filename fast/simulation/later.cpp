#include "fast/simulation/later.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fast/contact/parting.h"

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

/// A plane between two convex parts, and how far they are apart along its normal (m).
struct PlaneBetween {
  Vec3 nhat_BA_W;
  double gap;
};

/// For each part of one body and each of the other.
std::vector<PlaneBetween> planes_between(const BodyMotion& a, const BodyMotion& b, double now) {
  const lin_canny::CachedPose X_WA(a.ballistic().pose(now)), X_WB(b.ballistic().pose(now));
  std::vector<PlaneBetween> planes;
  for (const lin_canny::Convex& part_a : a.model().solid.parts()) {
    for (const lin_canny::Convex& part_b : b.model().solid.parts()) {
      const contact::Part A = contact::part_of(part_a, X_WA, {}), B = contact::part_of(part_b, X_WB, {});
      const Vec3 n = contact::parting(A, X_WA, B, X_WB);
      planes.push_back({n, std::max(0.0, apart(A, B, n))});
    }
  }
  return planes;
}

/// m: rotation moves no point of the body farther, but for points of a sphere, which take each other's places.
double lever(const BodyMotion& body) {
  return std::holds_alternative<Sphere>(body.body().shape) ? body.model().p_BBcm.norm() : body.radius();
}

/// A time (s) within which two bodies that touch cannot approach by more than a part of `within` (m). Two convex parts
/// have a separating plane, so that, apart from rotation, only motion along its normal brings them closer. If one body
/// slides on the other and no force presses them together, they never approach.
double time_apart(const BodyMotion& a, const BodyMotion& b, const Vec3& nhat_BA_W, double now, double within) {
  const Vec3 u = a.path().velocity(now) - b.path().velocity(now), du_dt = a.path().a - b.path().a;
  double speed = 0, acceleration = 0;  // of rotation
  for (const BodyMotion* body : {&a, &b}) {
    if (body->kind() != Kind::other) continue;  // a fixed body may turn too
    speed += body->ballistic().rate() * lever(*body);
    acceleration += body->ballistic().acceleration_per_radius() * lever(*body);
  }
  const auto time_along = [&](const PlaneBetween& plane) {
    const Vec3& n = plane.nhat_BA_W;
    const double s = speed + std::max(-n.dot(u), 0.0), dv = acceleration + std::max(-n.dot(du_dt), 0.0);
    const double way = plane.gap + within / 16, sum = s + std::sqrt(s * s + 2 * dv * way);
    return sum > 0 ? 2 * way / sum : never;
  };
  if (is_convex(a) && is_convex(b)) return time_along({nhat_BA_W, 0});
  double least = never;
  for (const PlaneBetween& plane : planes_between(a, b, now)) least = std::min(least, time_along(plane));
  return least;
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
