// Motions of random bodies, and of pairs that are thrown at each other.
#pragma once

#include "reference/convex_hull.h"
#include "tests/model/random_scene.h"

namespace touchstone::tests {

class RandomMotion {
 public:
  explicit RandomMotion(std::uint64_t seed) : bits_(seed) {}

  double unit() { return static_cast<double>(bits_.next() >> 11) * 0x1p-53; }
  double either() { return 2 * unit() - 1; }
  Vec3 vector() { return {either(), either(), either()}; }
  Quaternion turn() { return {either(), either(), either(), either()}; }

  Polytope hull(int points) {
    std::vector<Vec3> all;
    while (static_cast<int>(all.size()) < points) {
      const Vec3 v = vector();
      if (v.squaredNorm() > 0.01) all.push_back(v.normalized());
    }
    return reference::convex_hull(all);
  }

  /// 0: a ball, 1: a box, 2: a box with two equal sides, 3: given moments, 4: a hull, 5: principal axes other than the
  /// body's.
  Body body(int kind) {
    Body b;
    b.name = std::string("body");
    b.shape = Box{Vec3(0.2 + unit(), 0.2 + unit(), 0.2 + unit())};
    if (kind == 0) b.shape = Sphere{0.2 + unit()};
    if (kind == 2) b.shape = Box{Vec3(0.5, 0.5, 0.2 + unit())};
    if (kind == 3) b.mass = MassProperties{1, vector() / 8, Vec3(1, 1.5 + unit() / 2, 2).asDiagonal()};
    if (kind == 4) b.shape = hull(12);
    if (kind == 5) {
      Mat3 I;
      I << 2, 0.1, -0.2, 0.1, 1.75, 0.3, -0.2, 0.3, 2.25;
      b.mass = MassProperties{2, vector() / 8, I};
    }
    b.X_WB = {vector(), turn()};
    b.velocity = {3 * vector(), 5 * vector()};
    return b;
  }

  /// One body and, so that the scene has a pair, another far away.
  Scene alone(int kind) {
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.bodies = {body(kind), body(0)};
    scene.bodies[1].name = std::string("other");
    scene.bodies[1].X_WB.p_WB = Vec3(1000, 0, 0);
    scene.motion.emplace();
    scene.motion->sample_times = {2};
    return scene;
  }

  /// Two bodies that are thrown at each other from 3 m or 4 m; some touch.
  Scene pair(int kind_A, int kind_B) {
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.bodies = {body(kind_A), body(kind_B)};
    scene.bodies[0].name = std::string("A");
    scene.bodies[1].name = std::string("B");
    for (const int i : {0, 1}) {
      Body& b = scene.bodies[static_cast<std::size_t>(i)];
      const Vec3 side(i ? 2.5 : -2.5, 0, 0);
      b.X_WB.p_WB = side + vector() / 2;
      b.velocity.v_WBcm = -side + vector() / 2;
    }
    scene.motion.emplace();
    scene.motion->sample_times = {2};
    return scene;
  }

 private:
  Bits bits_;
};

}  // namespace touchstone::tests
