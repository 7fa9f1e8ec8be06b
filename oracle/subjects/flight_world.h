// How an engine that steps is asked what happens next: its world is stepped from look to look of the flight.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// An engine's world of the bodies of one scene.
class FlightWorld {
 public:
  virtual ~FlightWorld() = default;

  /// Each force acts at its body's centre of mass during the whole step.
  virtual void step(double seconds, const std::vector<Vec3>& forces_W) = 0;
  virtual State state(int body) const = 0;
};

/// What no engine that restores by `law` offers; none: the scene can be asked. Another law is as good where all agree:
/// without restitution, without friction, or among balls.
std::optional<Abstains> no_such_flight(const Scene& scene, Law law = Law::newton);

/// Between two looks (or pushes) as many equal steps of at most `dt` (s) as needed, so that each of them falls on a
/// step.
Trajectory follow(const Scene& scene, double dt, FlightWorld& world);

/// Where B is, of which an engine moves the frame E.
Pose pose_of_body(const Vec3& p_WE, const Eigen::Quaterniond& q_WE, const Pose& X_BE);

}  // namespace touchstone::oracle::subjects
