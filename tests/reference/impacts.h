// Impacts made to measure: one body, whose centre of mass is W's origin, against a fixed one.
#pragma once

#include "model/scene.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::tests {

struct Blow {
  double mass = 1;
  Mat3 I = Mat3::Identity();
  Vec3 r = Vec3(0, 0, -1);  ///< from the centre of mass to C
  Vec3 v = Vec3(0, 0, -1);
  Vec3 w = Vec3::Zero();
  Law law = Law::poisson;
  double e = 0.5;
  double mu = 0.5;
};

/// The normal is W's z.
inline Scene scene(const Blow& blow) {
  Body moved = body(Box{Vec3(1, 1, 1)});
  MassProperties properties;
  properties.mass = blow.mass;
  properties.I_BBcm_B = blow.I;
  moved.mass = properties;
  moved.velocity = {blow.v, blow.w};
  Body wall = body(Box{Vec3(1, 1, 1)}, Vec3(0, 0, -2));
  wall.mass = Fixed{};
  Scene result = pair(moved, wall);
  result.contact =
      Contact{.p_WC = blow.r, .nhat_BA_W = Vec3(0, 0, 1), .law = blow.law, .restitution = blow.e, .friction = blow.mu};
  return result;
}

inline Mat3 diagonal(double x, double y, double z) { return Vec3(x, y, z).asDiagonal(); }

/// Stronge's and Kane's paradox: a rod at 45°, K = [[5/2, −3/2], [−3/2, 5/2]] in its plane, slip stops in compression.
/// Velocities are 5 times those of the literature, so that they are doubles.
inline Scene newton_paradox(Law law) {
  return scene({.I = diagonal(6, 6, 6), .r = {-3, 0, -3}, .v = {3, 0, -5}, .law = law, .e = 1, .mu = 1});
}

/// A rod at tan φ = 2, μ = 2: K = [[17/5, −6/5], [−6/5, 8/5]]; friction drives it into the wall until slip stops.
inline Scene painleve(double u_t, double u_n) {
  return scene({.I = diagonal(15, 15, 15), .r = {-3, 0, -6}, .v = {u_t, 0, u_n}, .e = 0.5, .mu = 2});
}

}  // namespace touchstone::tests
