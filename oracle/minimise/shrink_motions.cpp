// Shorter motions: fewer times, no forces, one start, simpler coefficients and velocities.
#include <algorithm>

#include "oracle/minimise/shrink.h"

namespace touchstone::oracle::shrink {
namespace {

template <class Change>
Move changed_motion(Change change) {
  return [change](const Scene& before) -> std::optional<Scene> {
    if (!before.motion) return std::nullopt;
    Scene scene = before;
    change(scene);
    return scene;
  };
}

/// Ignores an index beyond the times: earlier moves may have removed some.
std::optional<Scene> without_time(Scene scene, std::size_t i) {
  if (!scene.motion || scene.motion->sample_times.size() < 2 || i >= scene.motion->sample_times.size())
    return std::nullopt;
  std::vector<double>& times = scene.motion->sample_times;
  times.erase(times.begin() + static_cast<std::ptrdiff_t>(i));
  return scene;
}

std::optional<Scene> without_push(Scene scene, std::size_t i) {
  if (!scene.motion || i >= scene.motion->forces.size()) return std::nullopt;
  std::vector<AppliedForce>& applied_forces = scene.motion->forces;
  applied_forces.erase(applied_forces.begin() + static_cast<std::ptrdiff_t>(i));
  return scene;
}

/// All velocities relative to that of body i, so that it does not move.
void seen_from(Scene& scene, std::size_t i) {
  if (i >= scene.bodies.size()) return;
  const Vec3 v = scene.bodies[i].velocity.v_WBcm;
  for (Body& body : scene.bodies) body.velocity.v_WBcm -= v;
}

template <class Change>
Move of_body(std::size_t i, Change change) {
  return changed_motion([i, change](Scene& scene) {
    if (i < scene.bodies.size()) change(scene.bodies[i]);
  });
}

}  // namespace

std::vector<Move> shrink_motions(const Scene& scene) {
  if (!scene.motion) return {};
  std::vector<Move> moves = {
      changed_motion([](Scene& s) { s.motion.reset(); }),
      changed_motion([](Scene& s) { s.motion->sample_times = {s.motion->sample_times.back()}; }),
      changed_motion([](Scene& s) { s.motion->sample_times = {s.motion->sample_times.front()}; }),
      changed_motion([](Scene& s) { s.motion->forces.clear(); }),
      changed_motion([](Scene& s) { s.motion->start_times.clear(); }),
      changed_motion([](Scene& s) { s.motion->envelope.reset(); }),
      changed_motion([](Scene& s) { s.motion->force_bound = 0; }),
      changed_motion([](Scene& s) { s.motion->law = Law::poisson; })};
  for (std::size_t i = scene.motion->sample_times.size(); i-- > 0;) {
    moves.push_back([i](const Scene& s) { return without_time(s, i); });
  }
  for (std::size_t i = scene.motion->forces.size(); i-- > 0;) {
    moves.push_back([i](const Scene& s) { return without_push(s, i); });
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    moves.push_back(changed_motion([i](Scene& s) { seen_from(s, i); }));
    moves.push_back(of_body(i, [](Body& body) { body.mass = Fixed{}; }));
    moves.push_back(of_body(i, [](Body& body) { body.mass = Density{}; }));
    moves.push_back(of_body(i, [](Body& body) { body.velocity.w_WB.setZero(); }));
    moves.push_back(of_body(i, [](Body& body) { body.velocity.v_WBcm.setZero(); }));
    for (const double plain : {0.0, 1.0}) {
      moves.push_back(of_body(i, [plain](Body& body) { body.material.friction = plain; }));
      moves.push_back(of_body(i, [plain](Body& body) { body.material.restitution = plain; }));
    }
  }
  return moves;
}

}  // namespace touchstone::oracle::shrink
