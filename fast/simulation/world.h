// The bodies of a simulation at the current time: trajectories, applied accelerations, coefficients, impacts so far.
#pragma once

#include <algorithm>
#include <vector>

#include "fast/simulation/impact.h"
#include "model/scene.h"

namespace touchstone::fast::simulation {

class World {
 public:
  /// Throws InputError if the motion is missing or a shape is not a solid, and BeyondDoubles (range.h). The scene must
  /// outlive the world.
  explicit World(const Scene& scene);

  const Scene& scene() const { return *scene_; }  ///< it has a motion
  double envelope() const { return envelope_; }
  double reach() const { return reach_; }  ///< m; bodies in contact that are this near take their steps together
  double end() const { return end_; }      ///< s; of the motion

  double now() const { return now_; }
  void advance_to(double time) { now_ = std::max(now_, time); }

  const std::vector<BodyMotion>& bodies() const { return bodies_; }
  const BodyMotion& body(BodyId id) const { return bodies_[id]; }
  BodyMotion& body(BodyId id) { return bodies_[id]; }
  double start_time(BodyId id) const;
  Coefficients coefficients(BodyId a, BodyId b) const;

  /// Restarts a body's trajectory from its reported state if by `until` it will have turned so far that its orientation
  /// is lost or slow to compute (BodyMotion::needs_restart). Returns false if it turns too fast to be followed until
  /// then even so.
  bool keep_orientation(BodyId id, double until) {
    BodyMotion& body = bodies_[id];
    if (!body.needs_restart(until)) return true;
    const double from = std::max(now_, body.path().since);
    body.restart(from, body.state(from), body.path().a, body.path().alpha);
    return body.follows(until);
  }

  const Vec3& acceleration(BodyId id) const { return acceleration_[id]; }  ///< m/s²; by gravity and the applied force
  const AppliedForce* next_force() const;                                  ///< null if there is none
  /// Sets the acceleration of the next force's body, which does not change its trajectory yet.
  void apply_next_force();

  /// `speed`: that of the body before the impact (m/s; `speed_bound` of response.h).
  void count_impact(BodyId id, double speed) {
    speed_before_[id] = std::max(speed, speed_before_impacts(id));
    last_impact_[id] = now_, ++impacts_[id];
  }
  bool had_impact_now(BodyId id) const { return last_impact_[id] == now_; }
  /// Of the body's impacts at this time (m/s); 0 if there is none.
  double speed_before_impacts(BodyId id) const { return had_impact_now(id) ? speed_before_[id] : 0; }
  std::uint64_t impacts(BodyId a, BodyId b) const { return impacts_[a] + impacts_[b]; }  ///< of either, with any body

 private:
  const Scene* scene_;
  double envelope_, reach_, end_;
  double now_ = 0;
  std::vector<BodyMotion> bodies_;
  std::vector<Vec3> acceleration_;  ///< indexed by body, like the next three: if it moves
  std::vector<double> last_impact_, speed_before_;
  std::vector<std::uint64_t> impacts_;
  std::size_t applied_forces_ = 0;
};

}  // namespace touchstone::fast::simulation
