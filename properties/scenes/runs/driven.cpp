// Runs in which something from outside drives the bodies: gravity along any axis, a fixed paddle that turns, a fixed
// plough, pushes that mirror each other, pushes before a body starts.
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
  scene.motion = std::move(motion);
  return scene;
}

/// Thrown against gravity, which is along any axis, at a plate that it just reaches, or does not, within a frame or
/// two.
Scene apex(Random& random) {
  constexpr double fall = 8;
  const double speed = dyadic(random, 1, 3, -4, 0), reach = speed * speed / (2 * fall);
  const double off = dyadic_gap(random, 4, 30);
  Body thrown = random.one_in(2) ? at_rest(Sphere{0.5}) : at_rest(Box{Vec3(0.25, 1, 0.5)});
  Body plate = fixed(at_rest(Box{Vec3(2, 2, 0.5)}));
  const Material material = some_material(random);
  thrown.material = plate.material = material;
  plate.X_WB.p_WB = {random.whole(-1, 1), 0, 1 + reach * (1 + off)};
  thrown.velocity.v_WBcm = {random.whole(-2, 2) * speed / 4, 0, speed};
  Scene scene = run({std::move(thrown), std::move(plate)}, motion_until(speed / 2, 4));
  scene.gravity = {0, 0, -fall};
  return turned_somehow(random, std::move(scene));
}

/// A fixed box that turns about its middle, among balls that it hits.
Scene paddle(Random& random) {
  Body paddle = fixed(at_rest(Box{Vec3(4, 0.5, 1)}));
  const double sign = random.sign();
  paddle.velocity.w_WB = {0, 0, sign * random.whole(1, 3) / 2};
  const Material material{random.pick({0.5, 1.0}), random.pick({0.0, 0.25})};
  std::vector<Body> bodies;
  const double first = random.sign();
  for (int n = random.between(0, 1); n >= 0; --n) {
    Body ball = at_rest(Sphere{0.5});
    const double side = n == 0 ? first : -first;
    ball.X_WB.p_WB = {random.whole(-3, 3), side * random.whole(2, 3), random.whole(-2, 2) / 4};
    bodies.push_back(std::move(ball));
  }
  bodies.insert(bodies.begin() + random.between(0, static_cast<int>(bodies.size())), std::move(paddle));
  for (Body& body : bodies) body.material = material;
  return turned_somehow(random, run(std::move(bodies), motion_until(2, 8)));
}

/// A fixed box that moves into a body at rest.
Scene plough(Random& random) {
  Body plough = fixed(at_rest(Box{Vec3(1, 2, 2)}));
  plough.X_WB.p_WB = {-4, 0, 0};
  plough.velocity.v_WBcm = {random.whole(2, 8), 0, 0};
  Body body = random.one_in(2) ? at_rest(Sphere{1}) : at_rest(Box{Vec3{0.5, random.whole(1, 2) / 2, 0.5}});
  body.X_WB.p_WB.y() = random.whole(-1, 1) / 2;
  const Material material{random.pick({0.0, 0.5, 1.0}), random.pick({0.0, 0.25})};
  plough.material = body.material = material;
  std::vector<Body> bodies = {std::move(body), std::move(plough)};
  if (random.one_in(2)) std::swap(bodies[0], bodies[1]);
  return run(std::move(bodies), motion_until(1, 4));
}

/// Equal balls that equal and opposite forces push at each other, or that equal forces push side by side.
Scene mirrored_pushes(Random& random) {
  MassProperties given;
  given.mass = random.whole(1, 2);
  given.I_BBcm_B = given.mass / 4 * Mat3::Identity();
  std::vector<Body> bodies(2, at_rest(Sphere{0.5}));
  const Material material = some_material(random);
  for (Body& body : bodies) body.mass = given, body.material = material;
  const double apart = random.whole(2, 4);
  bodies[1].X_WB.p_WB = {apart, 0, 0};
  Motion motion = motion_until(2, 8);
  motion.force_bound = 16;
  const double time = random.pick({0.25, 0.5}), push = given.mass * random.whole(2, 6);
  const Vec3 force{push, 0, 0}, other = random.one_in(4) ? force : -force;
  motion.forces = {{time, 0, force}, {time, 1, other}};
  return turned_somehow(random, run(std::move(bodies), std::move(motion)));
}

/// A ball is pushed before it starts, or as it starts; the other one is hit by it.
Scene pushed_before(Random& random) {
  std::vector<Body> bodies(2, at_rest(Sphere{1}));
  const Material material = some_material(random);
  for (Body& body : bodies) body.material = material;
  bodies[1].X_WB.p_WB = {random.whole(4, 6), random.whole(-1, 1), 0};
  Motion motion = motion_until(4, 8);
  const double start = random.pick({0.25, 0.5});
  motion.start_times = {start, 0};
  motion.force_bound = 64;
  const Vec3 aside = small_vector(random, 4), along{random.whole(4, 16), 0, 0};
  motion.forces = {{start / 2, 0, aside}, {random.one_in(2) ? start : 3 * start / 4, 0, along}};
  return run(std::move(bodies), std::move(motion));
}

}  // namespace

std::vector<Family> driven_run_families() {
  const std::vector<std::string> queries = {"simulation"};
  return {
      {"runs.apex", "thrown against gravity along any axis, at a plate that is just reached or not", queries, false,
       apex},
      {"runs.paddle", "a fixed box that turns and hits balls", queries, true, paddle},
      {"runs.plough", "a fixed box that moves into a body", {"simulation", "constraint"}, true, plough},
      {"runs.mirrored_pushes", "equal balls under equal and opposite forces", queries, true, mirrored_pushes},
      {"runs.pushed_before", "a body that is pushed before it starts", queries, true, pushed_before},
  };
}

}  // namespace touchstone::properties
