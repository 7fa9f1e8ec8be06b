// Simbody behind plain numbers: its headers do not compile as C++20 (its index types compare ambiguously there), and
// ours need C++20.
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

/// About the centre of mass, in the body's axes (kg m²): given as a matrix, or computed by Simbody for a uniform solid.
using Moments = std::variant<Eigen::Matrix3d, BallOf, BrickOf>;

/// In axes at its centre of mass. A body of mass 0 is part of the ground.
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

/// The velocities of bodies 0 (A) and 1 (B) after an impact at C, computed by Simbody's time stepper. Passes on
/// Simbody's exceptions.
std::array<Twist, 2> impact(const std::array<RigidBody, 2>& bodies, const PointContact& contact);

std::string version();

}  // namespace touchstone::oracle::subjects::in_simbody
