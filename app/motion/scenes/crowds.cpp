// Many bodies in a room. The known truth is what they conserve.
#include "app/motion/scenes/build.h"
#include "app/motion/scenes/list.h"
#include "app/motion/scenes/truths.h"
#include "properties/random.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

using properties::Random;

Vec3 within(Random& random, double most) {
  const auto one = [&] { return most * (2 * random.unit() - 1); };
  const double x = one(), y = one();
  return {x, y, one()};
}

/// Point k of a room's lattice; each lattice point is at least half a step away from the walls.
Vec3 lattice(int k, int side, double step) {
  return step * Vec3(k % side + 0.5, k / side % side + 0.5, k / (side * side) + 0.5);
}

MotionScene gas() {
  Random random(1, "gas", 0);
  std::vector<Body> bodies = room(4);
  for (int k = 0; k < 64; ++k) bodies.push_back(ball(0.25, lattice(k, 4, 1), {within(random, 4), Vec3::Zero()}));
  const Scene scene = scene_of("gas", bodies, {.g = 0, .restitution = 1, .step = 0.25, .samples = 16});
  return {scene, "64 balls in a room, e = 1: energy stays; relative to it", off_energy(scene)};
}

/// After SimBenchmark's elastic 666 balls.
MotionScene balls_666() {
  Random random(1, "balls_666", 0);
  std::vector<Body> bodies{table()};
  for (int k = 0; k < 666; ++k) {
    const Vec3 v = within(random, 0.25);  // first: the order of two draws in one call is the compiler's
    bodies.push_back(ball(0.5, lattice(k, 9, 1.25) + within(random, 0.0625), {v, Vec3::Zero()}));
  }
  const Scene scene = scene_of("balls_666", bodies, {.restitution = 1, .step = 0.125, .samples = 8});
  return {scene, "666 balls dropped upon each other, e = 1: energy stays; relative to it", off_energy(scene)};
}

/// The hull of points on a sphere, so that every point is a corner.
Polytope random_polytope(Random& random, int vertices, double radius) {
  Polytope polytope;
  while (static_cast<int>(polytope.vertices.size()) < vertices) {
    const Vec3 p = within(random, 1);
    if (p.squaredNorm() > 0.01 && p.squaredNorm() < 1) polytope.vertices.push_back(radius * p.normalized());
  }
  return polytope;
}

/// After I-COLLIDE's simulation: polytopes of 20 vertices that drift, rotate and bounce in a room.
MotionScene polytopes() {
  Random random(1, "polytopes", 0);
  std::vector<Body> bodies = room(4);
  for (int k = 0; k < 8; ++k) {
    const Velocity V{within(random, 4), within(random, 4)};
    bodies.push_back(body_of(random_polytope(random, 20, 0.75), lattice(k, 2, 2), V));
  }
  const Scene scene =
      reference::completed(scene_of("polytopes", bodies, {.g = 0, .restitution = 1, .step = 0.25, .samples = 8}));
  return {scene, "8 polytopes in a room, e = 1, no friction: energy stays; relative to it", off_energy(scene)};
}

/// Settles into a heap with many resting contacts, which are hard for methods based on impulses.
MotionScene heap() {
  Random random(1, "heap", 0);
  std::vector<Body> bodies = room(3);
  for (int k = 0; k < 18; ++k) {
    bodies.push_back(ball(0.375, lattice(k, 3, 1) + within(random, 0.0625)));
  }
  const Scene scene = scene_of("heap", bodies, {.restitution = 0.25, .friction = 0.5, .step = 0.125, .samples = 16});
  return {scene, "18 balls fall into a heap: energy never rises; relative to it", gained_energy(scene)};
}

/// The first domino rotates about its lower edge: v = w × (from the edge to the centre).
MotionScene dominoes() {
  std::vector<Body> bodies{table()};
  for (int k = 0; k < 6; ++k) bodies.push_back(block({0.125, 0.5, 1}, {0.75 * k, 0, 1}));
  bodies[1].velocity = {{2, 0, 0.25}, {0, 2, 0}};
  const Scene scene = scene_of("dominoes", bodies, {.friction = 0.5, .step = 0.125, .samples = 16});
  return {scene, "six dominoes fall: energy never rises; relative to it", gained_energy(scene)};
}

}  // namespace

std::vector<MotionScene> crowd_scenes() { return {gas(), balls_666(), polytopes(), heap(), dominoes()}; }

}  // namespace touchstone::app
