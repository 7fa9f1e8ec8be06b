// Runs of bodies that rest on each other until something changes: a push, a support that moves away, a slow slip, a
// neighbour that starts.
#include <algorithm>
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/scenes/thrown.h"

namespace touchstone::properties {
namespace {

Scene run(std::vector<Body> bodies, Motion motion) {
  Scene scene;
  scene.bodies = std::move(bodies);
  scene.gravity = {0, 0, -8};
  scene.motion = std::move(motion);
  scene.motion->law = Law::poisson;
  return scene;
}

/// Boxes on each other, the lowest at z = 0, each over the middle of the one below; rough, of density 1.
std::vector<Body> stack(Random& random, int count) {
  std::vector<Body> boxes;
  double top = 0;
  for (int n = 0; n < count; ++n) {
    const double height = random.whole(1, 3) / 4;
    Body box = at_rest(Box{Vec3(random.whole(2, 4) / 4, random.whole(2, 4) / 4, height)});
    box.X_WB.p_WB = {0, 0, top + height};
    box.mass = Density{1};
    box.material = {0, random.pick({0.25, 0.5, 1.0})};
    boxes.push_back(std::move(box));
    top += 2 * height;
  }
  return boxes;
}

/// N
double weight(const Body& box) { return 8 * 8 * std::get<Box>(box.shape).half_extents.prod(); }

/// A stack that rests on a table without friction, until a force along the table pulls one of its boxes.
Scene wakes(Random& random) {
  const int count = random.between(2, 3), pulled = random.below(count);
  std::vector<Body> bodies = stack(random, count);
  const double force = weight(bodies[static_cast<std::size_t>(pulled)]) * random.pick({0.125, 0.5, 1.0, 4.0});
  Motion motion = motion_until(1, 8);
  motion.force_bound = 8 * force;
  motion.forces = {{random.pick({0.25, 0.5}), pulled, Vec3(random.sign() * force, 0, 0)}};
  bodies.push_back(large_table({0, 0}));
  return run(std::move(bodies), std::move(motion));
}

/// A smooth box drifts slowly on two rough ones, which rest on a table without friction.
Scene drifts(Random& random) {
  std::vector<Body> bodies = stack(random, 3);
  bodies[2].material.friction = 0;
  Motion motion = motion_until(1, 8);
  if (random.one_in(2)) motion.envelope = 0x1p-13;
  bodies[2].velocity.v_WBcm = {random.sign() * (motion.envelope ? 0x1p-4 : 0x1p-12) * random.whole(1, 4), 0, 0};
  bodies.push_back(large_table({0, 0}));
  if (random.one_in(2)) std::ranges::reverse(bodies);
  return run(std::move(bodies), std::move(motion));
}

/// A fixed plate that moves away from under a box or a ball, which falls when it has left it.
Scene plate_leaves(Random& random) {
  Body plate = fixed(at_rest(Box{Vec3(random.whole(1, 2), 2, 1)}, {{0, 0, -1}, {}}));
  plate.velocity.v_WBcm = {random.sign() * random.whole(1, 4), 0, 0};
  const double size = random.pick({0.25, 0.5});
  Body body = random.one_in(3) ? at_rest(Sphere{size}) : at_rest(Box{Vec3(size, random.pick({0.25, 0.5}), size)});
  body.mass = Density{1};
  body.X_WB.p_WB = {random.whole(-1, 1) / 2, 0, size};
  plate.material = body.material = {0, random.pick({0.0, 0.0, 0.0625})};
  std::vector<Body> bodies = {std::move(plate), std::move(body)};
  if (random.one_in(2)) std::ranges::reverse(bodies);
  return run(std::move(bodies), motion_until(4, 16));
}

/// A stack, or a ball, on a belt, with its velocity or at rest on a table: often slower than what counts as rest.
Scene on_a_belt(Random& random) {
  std::vector<Body> bodies = stack(random, random.between(1, 3));
  if (random.one_in(4)) {
    bodies = {at_rest(Sphere{0.5}, {{0, 0, 0.5}, {}})};
    bodies[0].material = {0, 0.5};
  }
  Motion motion = motion_until(1, 8);
  if (random.one_in(2)) motion.envelope = 0x1p-13;
  const double speed = (motion.envelope ? 0x1p-5 : 0x1p-12) * random.whole(0, 2);
  bodies.push_back(large_table({0, 0.5}));
  const Vec3 v{random.sign() * speed, random.one_in(2) ? speed : 0, 0};
  for (Body& body : bodies) body.velocity.v_WBcm = v;
  if (random.one_in(2)) std::ranges::reverse(bodies);
  return run(std::move(bodies), std::move(motion));
}

/// Two balls that meet where a third one will be, which starts when both have passed that place.
Scene waits(Random& random) {
  std::vector<Body> bodies(3, at_rest(Sphere{1}));
  const double speed = random.whole(2, 4), meet = random.pick({0.5, 1.0});
  bodies[0].X_WB.p_WB = {-speed * meet, 0, 0};
  bodies[1].X_WB.p_WB = {2 - meet, 0, 0};
  bodies[2].X_WB.p_WB = {4, 0, 0};
  bodies[0].velocity.v_WBcm = {speed, 0, 0};
  bodies[1].velocity.v_WBcm = {1, 0, 0};
  for (Body& body : bodies) body.material = {1, 0};  // the slower ball passes at 1 m/s
  Motion motion;
  motion.start_times = {0, 0, 16};
  motion.sample_times = {16.5, 17};
  Scene scene = run(std::move(bodies), std::move(motion));
  scene.gravity.setZero();
  return turned_somehow(random, std::move(scene));
}

}  // namespace

std::vector<Family> stacked_run_families() {
  const std::vector<std::string> queries = {"simulation"}, both = {"simulation", "constraint"};
  return {
      {"runs.wakes", "boxes on each other on ice, of which one is pulled after a while", both, true, wakes},
      {"runs.drifts", "a smooth box that drifts on two rough ones on ice", both, true, drifts},
      {"runs.plate_leaves", "a fixed plate that moves away from under a body", queries, true, plate_leaves},
      {"runs.on_a_belt", "a stack or a ball that moves with a belt, or rests on a table", queries, true, on_a_belt},
      {"runs.waits", "balls that meet where one that starts later will be", queries, true, waits},
  };
}

}  // namespace touchstone::properties
