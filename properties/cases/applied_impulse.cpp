#include "properties/cases/applied_impulse.h"

#include <cstddef>

namespace touchstone::properties {

AppliedImpulse applied_until(const Scene& scene, double time) {
  AppliedImpulse sum;
  sum.of_bodies.resize(scene.bodies.size(), 0.0);
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    Vec3 force = Vec3::Zero();
    double since = 0;
    const auto acts_until = [&](double end) {
      sum.total += (end - since) * force;
      sum.of_bodies[body] += (end - since) * force.norm();
      since = end;
    };
    for (const AppliedForce& applied : scene.motion->forces) {
      if (static_cast<std::size_t>(applied.body) != body || applied.time > time) continue;
      acts_until(applied.time);
      sum.changes += (applied.force_W - force).norm();
      force = applied.force_W;
    }
    acts_until(time);
  }
  return sum;
}

}  // namespace touchstone::properties
