// Impacts made to measure: one body, whose centre of mass is W's origin, against a fixed one.
#pragma once

#include "model/scene.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::tests {

struct ImpactProblem {
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
inline Scene scene(const ImpactProblem& problem) {
  Body moved = body(Box{Vec3(1, 1, 1)});
  MassProperties properties;
  properties.mass = problem.mass;
  properties.I_BBcm_B = problem.I;
  moved.mass = properties;
  moved.velocity = {problem.v, problem.w};
  Body wall = body(Box{Vec3(1, 1, 1)}, Vec3(0, 0, -2));
  wall.mass = Fixed{};
  Scene result = pair(moved, wall);
  result.contact = Contact{.p_WC = problem.r,
                           .nhat_BA_W = Vec3(0, 0, 1),
                           .law = problem.law,
                           .restitution = problem.e,
                           .friction = problem.mu};
  return result;
}

inline Mat3 diagonal(double x, double y, double z) { return Vec3(x, y, z).asDiagonal(); }

// Impacts with a name; docs/scenes/impact holds each of them as NAME.json. A body on a fixed one realises any K.

/// Newton's law creates energy where slip stops: a rod at 45°, K = [[5/2, −3/2], [−3/2, 5/2]] in its plane. Velocities
/// are 5 times those of the literature, so that they are doubles.
inline Scene newton_paradox(Law law = Law::newton) {
  return scene({.I = diagonal(6, 6, 6), .r = {-3, 0, -3}, .v = {3, 0, -5}, .law = law, .e = 1, .mu = 1});
}

/// A rod at tan φ = 2: K = [[17/5, −6/5], [−6/5, 8/5]] in its plane.
inline ImpactProblem rod(const Vec3& v, double mu) {
  return {.I = diagonal(15, 15, 15), .r = {-3, 0, -6}, .v = v, .e = 0.5, .mu = mu};
}

/// Friction drives it into the wall until slip stops.
inline Scene painleve(double u_t = -100, double u_n = -1) { return scene(rod({u_t, 0, u_n}, 2)); }

/// No slip before, but friction cannot hold the point.
inline Scene unstable_sticking() { return scene(rod({0, 0, -1}, 0.25)); }

/// Slip stops and comes back.
inline Scene slip_reversal() { return scene(rod({1, 0, -2}, 0.25)); }

/// A ball of 5 kg and 1 m: K = diag(7/2, 7/2, 1)/m.
inline Scene rough_sphere(double mu = 0.25) {
  return scene({.mass = 5, .I = diagonal(2, 2, 2), .v = {7, 0, -4}, .e = 0.5, .mu = mu});
}

/// Slip turns so that u_n rises, falls and rises again: Poisson's restitution ends with the bodies approaching.
inline Scene recompression() {
  return scene({.I = diagonal(2, 2, 2), .r = {0, 7, -6}, .v = {-9, -3, -4}, .e = 1, .mu = 1.5});
}

}  // namespace touchstone::tests
