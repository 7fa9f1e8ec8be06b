#include "fast/simulation/world.h"

#include <algorithm>

#include "fast/simulation/range.h"
#include "model/input_error.h"
#include "model/limits.h"

namespace touchstone::fast::simulation {
namespace {

/// The least size of the bodies that move; 0 if there are none.
double least_size(const Scene& scene) {
  double smallest = never;
  for (const Body& body : scene.bodies) {
    if (!std::holds_alternative<Fixed>(body.mass)) smallest = std::min(smallest, size(body.shape));
  }
  return smallest < never ? smallest : 0;
}

double end_of(const Scene& scene) {
  if (!scene.motion) throw InputError("motion", "is missing: a simulation needs one");
  return scene.motion->sample_times.back();
}

std::vector<BodyMotion> body_motions(const Scene& scene) {
  const std::vector<double>& start_times = scene.motion->start_times;
  std::vector<BodyMotion> bodies;
  bodies.reserve(scene.bodies.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    bodies.emplace_back(scene.bodies[i], start_times.empty() ? 0 : start_times[i], scene.gravity);
  }
  refuse_beyond_doubles(scene, bodies);
  return bodies;
}

}  // namespace

World::World(const Scene& scene)
    : scene_(&scene),
      envelope_(touchstone::envelope(scene)),
      reach_(std::max(envelope_, 0x1p-8 * least_size(scene))),
      end_(end_of(scene)),
      bodies_(body_motions(scene)),
      acceleration_(bodies_.size(), scene.gravity),
      last_impact_(bodies_.size(), -never),
      speed_before_(bodies_.size(), 0),
      impacts_(bodies_.size(), 0) {}

double World::start_time(BodyId id) const {
  const std::vector<double>& start_times = scene_->motion->start_times;
  return start_times.empty() ? 0 : start_times[id];
}

Coefficients World::coefficients(BodyId a, BodyId b) const {
  return simulation::coefficients(bodies_[a], bodies_[b], scene_->motion->law);
}

const AppliedForce* World::next_force() const {
  const std::vector<AppliedForce>& forces = scene_->motion->forces;
  return applied_forces_ < forces.size() ? &forces[applied_forces_] : nullptr;
}

void World::apply_next_force() {
  const AppliedForce& force = *next_force();
  const auto id = static_cast<BodyId>(force.body);
  acceleration_[id] = scene_->gravity + bodies_[id].inverse_mass() * force.force_W;
  ++applied_forces_;
}

}  // namespace touchstone::fast::simulation
