#include "properties/scenes/thrown.h"

#include <algorithm>
#include <utility>

#include "properties/scenes/pair.h"
#include "properties/scenes/solids.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {

Body some_ball(Random& random) { return at_rest(Sphere{random.whole(1, 4)}); }

Body some_box(Random& random) {
  const Vec3 half{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
  return at_rest(Box{half});
}

Body some_solid(Random& random) {
  const int kind = random.below(5);
  Body body = some_ball(random);
  if (kind >= 1) body = some_box(random);
  const double height = random.whole(1, 4);
  if (kind == 2) body.shape = prism(some_polygon(random), -height, height);
  if (kind == 3) body.shape = pyramid(some_polygon(random), -height, height);
  if (kind == 4) body.shape = bipyramid(some_polygon(random), -height, height);
  if (random.one_in(2)) body.X_WB.q_WB = small_quaternion(random);
  return body;
}

Body with_mass(Random& random, Body body) {
  const double density = dyadic(random, 1, 4, -2, 2);
  body.mass = Density{density};
  if (!random.one_in(4)) return body;
  MassProperties given;
  given.mass = dyadic(random, 1, 4, 0, 4);
  const double a = random.whole(2, 6), b = random.whole(2, 6);
  const Vec3 moments = random.pick<Vec3>({Vec3(a, b, std::max(a, b) + 1), Vec3(a, a, a + 1), Vec3(a, a, a)});
  given.I_BBcm_B = (given.mass * moments).asDiagonal();
  body.mass = given;
  return body;
}

Body spun(Random& random, Body body) {
  const Vec3 spin = small_vector(random, 3);
  body.velocity.w_WB = spin;
  const bool ball = std::holds_alternative<Sphere>(body.shape) && std::holds_alternative<Density>(body.mass);
  if (ball) return body;
  if (random.one_in(8)) {
    body.velocity.w_WB = spin / 16;
    return body;
  }
  MassProperties given;
  given.mass = dyadic(random, 1, 4, 0, 4);
  given.I_BBcm_B = 2 * given.mass * Mat3::Identity();
  body.mass = given;
  return body;
}

Mat3 unlike_moments(Random& random) { return random.pick<Vec3>({{2, 3, 4}, {4, 2, 3}, {2, 2, 3}}).asDiagonal(); }

Body fixed(Body body) {
  body.mass = Fixed{};
  return body;
}

Body large_table(const Material& material) {
  Body table = fixed(at_rest(Box{Vec3(256, 256, 2)}, {{0, 0, -2}, {}}));
  table.material = material;
  return table;
}

Body at(Body body, const Vec3& p) {
  body.X_WB.p_WB = p;
  return body;
}

Body moving(Body body, const Vec3& v, const Vec3& w) {
  body.velocity = {v, w};
  return body;
}

Motion motion_until(double end, int samples) {
  Motion motion;
  for (int sample = 1; sample <= samples; ++sample) motion.sample_times.push_back(end * sample / samples);
  return motion;
}

Material some_material(Random& random) {
  const double restitution = random.pick({0.5, 0.75, 1.0, 1.0});
  return {restitution, random.pick({0.0, 0.0, 0.25, 0.5, 1.0})};
}

Scene turned_somehow(Random& random, Scene scene) {
  for (int turns = random.below(3); turns > 0; --turns) scene = turned(scene).value_or(scene);
  return random.one_in(2) ? half_turned(std::move(scene)) : scene;
}

Scene thrown(Random& random, Body A, Body B, Motion motion, const Vec3& gravity) {
  Scene scene;
  scene.bodies = {std::move(A), std::move(B)};
  scene.gravity = gravity;
  scene.motion = std::move(motion);
  scene = turned_somehow(random, std::move(scene));
  return random.one_in(2) ? swapped(std::move(scene)) : scene;
}

}  // namespace touchstone::properties
