// Balls and blocks simulated by Simbody, behind an interface of plain numbers. Contacts are declared in advance.
#pragma once

#include <memory>
#include <vector>

#include "oracle/subjects/simbody/stepper.h"

namespace touchstone::oracle::subjects::in_simbody {

/// A face of a fixed body. Simbody treats it as an infinite plane.
struct Face {
  Eigen::Vector3d p_WF;
  Eigen::Vector3d nhat_W;  ///< outward from the solid
};

struct Coefficients {
  double e, mu;
};

/// A ball with its centre at p_BC, in the axes at the body's centre of mass; a radius of 0 makes it a corner.
struct OnFace {
  std::size_t body;
  Eigen::Vector3d p_BC;
  double radius;
  Face face;
  Coefficients pair;
};

struct BallOnBall {
  std::size_t a, b;
  double radius_a, radius_b;
  Coefficients pair;
};

struct Place {
  Eigen::Vector3d p_WBcm;
  Eigen::Quaterniond q_WB;
  Twist twist;
};

/// m. Simbody's default distance at which a contact becomes active.
inline constexpr double default_tolerance = 1e-3;

/// m/s. By default Simbody restores nothing of a slower approach.
inline constexpr double default_capture = 2 * default_tolerance;

/// Bodies of mass 0 stand where they are.
class RigidBodies {
 public:
  RigidBodies(const std::vector<RigidBody>& bodies, const std::vector<OnFace>& on_faces,
              const std::vector<BallOnBall>& on_balls, const Eigen::Vector3d& gravity, Restitution restitution);
  ~RigidBodies();

  void step(double seconds, const std::vector<Eigen::Vector3d>& forces_W);
  Place place(std::size_t body) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace touchstone::oracle::subjects::in_simbody
