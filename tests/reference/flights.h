// Pairs in flight: random, head on, past each other, and just so.
#pragma once

#include <vector>

#include "tests/reference/hard_pairs.h"

namespace touchstone::tests {

/// Moments of inertia that are all the same: the body turns as a screw does.
inline MassProperties round_mass(double mass = 1, double moment = 1) {
  MassProperties properties;
  properties.mass = mass;
  properties.I_BBcm_B = moment * Mat3::Identity();
  return properties;
}

inline Quaternion random_quaternion(Dice& dice) {
  return {dice.around_zero(), dice.around_zero(), dice.around_zero(), dice.around_zero()};
}

/// Both fly for `end` seconds, as they stand.
inline Scene flight_of(Scene scene, double end) {
  scene.flight = Flight{.times = {end}};
  return scene;
}

/// Hulls of n points of the unit ball, 4 apart in some direction, that fly at each other more or less.
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
  return flight_of(scene, 2);
}

}  // namespace touchstone::tests
