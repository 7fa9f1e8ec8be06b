// Small scenes for tests of the simulation.
#pragma once

#include <cmath>

#include "fast/simulation.h"

namespace touchstone::fast {

inline const Vec3 still = Vec3::Zero(), up(0, 0, 1), g_W(0, 0, -10);

inline Body ball(double radius, const Vec3& p, const Vec3& v, const Material& material, double mass = 1) {
  Body body;
  body.shape = Sphere{radius};
  body.X_WB.p_WB = p;
  body.velocity.v_WBcm = v;
  body.material = material;
  body.mass = MassProperties{mass, Vec3::Zero(), 0.4 * mass * radius * radius * Mat3::Identity()};
  return body;
}

inline Body brick(const Vec3& half_extents, const Vec3& p, const Material& material) {
  Body body;
  body.shape = Box{half_extents};
  body.X_WB.p_WB = p;
  body.material = material;
  return body;
}

/// Its upper face is at z = 0.
inline Body table(double half_side = 100) {
  Body body = brick(Vec3(half_side, half_side, 1), Vec3(0, 0, -1), {1, 10});
  body.mass = Fixed{};
  return body;
}

inline Scene moving_scene(std::vector<Body> bodies, const Vec3& gravity, std::vector<double> times) {
  Scene scene;
  scene.bodies = std::move(bodies);
  scene.gravity = gravity;
  scene.motion.emplace();
  scene.motion->sample_times = std::move(times);
  return scene;
}

/// n³ balls in a box of six walls.
inline Scene gas(int n, const Material& material) {
  std::vector<Body> bodies;
  const double side = 0.1 * n;
  for (int i = 0; i < n * n * n; ++i) {
    const double a = 0.37 * i, b = 0.61 * i, c = 0.83 * i;  // velocities without a pattern
    bodies.push_back(ball(0.03, Vec3(i % n + 0.5, i / n % n + 0.5, i / n / n + 0.5) * 0.1,
                          Vec3(a - std::floor(a) - 0.5, b - std::floor(b) - 0.5, c - std::floor(c) - 0.5), material));
  }
  for (int wall = 0; wall < 6; ++wall) {
    Vec3 half = Vec3::Constant(side), p = Vec3::Constant(side / 2);
    half[wall % 3] = 0.5;
    p[wall % 3] = wall < 3 ? -0.5 : side + 0.5;
    bodies.push_back(brick(half, p, {1, 10}));
    bodies.back().mass = Fixed{};
  }
  return moving_scene(bodies, Vec3::Zero(), {1});
}

inline double kinetic(const Scene& scene, const std::vector<State>& states) {
  double sum = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (const auto* mass = std::get_if<MassProperties>(&scene.bodies[i].mass)) {
      const Velocity& v = states[i].velocity;
      sum += mass->mass * v.v_WBcm.squaredNorm() / 2 + mass->I_BBcm_B(0, 0) * v.w_WB.squaredNorm() / 2;
    }
  }
  return sum;
}

inline double kinetic(const Scene& scene) {
  std::vector<State> states;
  for (const Body& body : scene.bodies) states.push_back({body.X_WB, body.velocity});
  return kinetic(scene, states);
}

inline std::vector<Event> of_kind(const Simulated& done, Event::Kind kind) {
  std::vector<Event> found;
  for (const Event& event : *done.trajectory.events) {
    if (event.kind == kind) found.push_back(event);
  }
  return found;
}

}  // namespace touchstone::fast
