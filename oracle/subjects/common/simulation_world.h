// Simulation from a time-stepping engine: its world is stepped from one sample time to the next.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// An engine's world of the bodies of one scene.
class SimulationWorld {
 public:
  virtual ~SimulationWorld() = default;

  /// Each force acts at its body's centre of mass during the whole step.
  virtual void step(double seconds, const std::vector<Vec3>& forces_W) = 0;
  virtual State state(int body) const = 0;
};

/// What no engine that restores by `law` offers; none: the scene can be asked. Another law is as good where all agree:
/// without restitution, without friction, or among balls.
std::optional<Abstains> no_such_motion(const Scene& scene, Law law = Law::newton);

inline constexpr double default_step = 1.0 / 256;  ///< s, the longest step of an engine

/// Between two looks (or pushes) as many equal steps of at most `dt` (s) as needed, so that each of them falls on a
/// step.
Trajectory follow(const Scene& scene, double dt, SimulationWorld& world);

/// X_WB, from the pose of the frame E that the engine moves.
Pose pose_of_body(const Vec3& p_WE, const Eigen::Quaterniond& q_WE, const Pose& X_BE);

}  // namespace touchstone::oracle::subjects
