// Functions that build bodies and scenes in motion.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/scene.h"

namespace touchstone::app {

inline Body body_of(Shape shape, const Vec3& p, const Velocity& velocity = {}) {
  Body body;
  body.shape = std::move(shape);
  body.X_WB.p_WB = p;
  body.velocity = velocity;
  return body;
}

inline Body ball(double radius, const Vec3& p, const Velocity& velocity = {}) {
  return body_of(Sphere{radius}, p, velocity);
}

inline Body block(const Vec3& half_extents, const Vec3& p, const Velocity& velocity = {}) {
  return body_of(Box{half_extents}, p, velocity);
}

inline Body fixed_block(const Vec3& half_extents, const Vec3& p) {
  Body body = block(half_extents, p);
  body.mass = Fixed{};
  return body;
}

/// Its top is the plane z = 0.
inline Body table(double half_side = 32) { return fixed_block({half_side, half_side, 1}, {0, 0, -1}); }

/// A solid ball with a given mass, a double.
inline Body weighed_ball(double mass, double radius, const Vec3& p, const Velocity& velocity = {}) {
  Body body = ball(radius, p, velocity);
  body.mass = MassProperties{mass, Vec3::Zero(), 0.4 * mass * radius * radius * Mat3::Identity()};
  return body;
}

/// Six fixed blocks around [0, side]³ that touch one another along its edges.
std::vector<Body> room(double side);

struct Setting {
  double g = 10;  ///< m/s², downwards
  double restitution = 0;
  double friction = 0;
  double step = 0.1;  ///< s, between samples
  int samples = 10;
};

/// All bodies have the same material.
Scene scene_of(const std::string& name, std::vector<Body> bodies, const Setting& setting);

}  // namespace touchstone::app
