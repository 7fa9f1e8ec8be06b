// Simbody behind plain numbers: its headers are not C++20 (its index types compare ambiguously there), ours are no
// less.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <variant>

namespace touchstone::oracle::subjects::in_simbody {

struct BallOf {
  double radius;
};
struct BrickOf {
  Eigen::Vector3d half_extents;
};

/// Given, or of a uniform solid: then Simbody's own. About the centre of mass, in the body's axes (kg m²).
using Moments = std::variant<Eigen::Matrix3d, BallOf, BrickOf>;

/// About its centre of mass; mass 0: part of the ground.
struct RigidBody {
  double mass = 0;
  Moments moments;
  Eigen::Vector3d p_WBcm = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v_WBcm = Eigen::Vector3d::Zero();
  Eigen::Vector3d w_WB = Eigen::Vector3d::Zero();
};

enum class Restitution { poisson, newton };

struct PointContact {
  Eigen::Vector3d p_WC, nhat_BA_W;
  Restitution restitution;
  double e, mu;
};

struct Twist {
  Eigen::Vector3d v_WBcm, w_WB;
};

/// The velocities after bodies 0 (A) and 1 (B) have met at C, as its time stepper makes them. Throws what Simbody
/// throws.
std::array<Twist, 2> impact(const std::array<RigidBody, 2>& bodies, const PointContact& contact);

std::string version();

}  // namespace touchstone::oracle::subjects::in_simbody
