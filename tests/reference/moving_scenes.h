// Scenes of bodies in ballistic motion.
#pragma once

#include <vector>

#include "tests/reference/hard_pairs.h"

namespace touchstone::tests {

/// Equal moments of inertia, so that the motion is a screw motion.
inline MassProperties round_mass(double mass = 1, double moment = 1) {
  MassProperties properties;
  properties.mass = mass;
  properties.I_BBcm_B = moment * Mat3::Identity();
  return properties;
}

inline Quaternion random_quaternion(Dice& dice) {
  return {dice.around_zero(), dice.around_zero(), dice.around_zero(), dice.around_zero()};
}

/// The scene with a motion from 0 to `end` (s).
inline Scene moving_scene(Scene scene, double end) {
  scene.motion = Motion{.sample_times = {end}};
  return scene;
}

/// Two hulls of n points of the unit ball, 4 m apart in a random direction, that roughly approach each other.
inline Scene ballistic_pair(Dice& dice, int n, double spin = 5) {
  Scene scene;
  const Vec3 away = 4 * dice.in_cube().normalized();
  for (int i = 0; i < 2; ++i) {
    Body hull = body(round_hull(dice, n), i * away, random_quaternion(dice));
    hull.name = std::string(1, i == 0 ? 'A' : 'B');
    hull.mass = round_mass();
    hull.velocity.v_WBcm = (i == 0 ? 1 : -1) * (1 + dice.unit()) * away / 2 + dice.in_cube();
    hull.velocity.w_WB = spin * dice.in_cube();
    scene.bodies.push_back(hull);
  }
  scene.gravity = Vec3(0, 0, -9.8125);
  return moving_scene(scene, 2);
}

}  // namespace touchstone::tests
