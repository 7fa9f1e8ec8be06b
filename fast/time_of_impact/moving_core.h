// One convex part of a body in ballistic motion at one time, with bounds on its motion from then on.
#pragma once

#include "fast/lin_canny/posed_hull.h"
#include "fast/motion/ballistic_motion.h"

namespace touchstone::fast::time_of_impact {

/// A point at r from the centre of mass, in W, is known within the core's errors and moves at v + w × r (v known within
/// v_error, w within w_error), and |p̈ − acceleration| ≤ acceleration_per_radius |r| (motion/ballistic_motion.h).
struct MovingCore {
  lin_canny::PosedHull core;         ///< in the pair's frame; its errors include the motion's
  double radius = 0;                 ///< m; of the part around its core
  Vec3 arm = Vec3::Zero();           ///< m; from the centre of mass to the core's origin
  Vec3 v = Vec3::Zero();             ///< m/s; of the centre of mass, relative to O
  Vec3 w = Vec3::Zero();             ///< rad/s
  double slope_error = 0;            ///< m/s; error of n·velocity of any core point, |n| = 1
  Vec3 acceleration = Vec3::Zero();  ///< m/s²; of the centre of mass, relative to O
  Vec3 alpha = Vec3::Zero();         ///< rad/s²
  double acceleration_bound = 0;     ///< m/s²; ≥ |p̈ − acceleration| of all core points, at all times
  double bend_error = 0;             ///< m/s²; error of n·p̈ as computed from w and alpha
  double jerk_bound = 0;             ///< m/s³; ≥ |p⃛| of all core points, at all times
};

/// Part `part` of the moving body at time t, in W's axes, relative to O.
MovingCore moving_core(const motion::BallisticMotion& motion, std::size_t part, double t, const motion::Origin& O);

/// The ball around the centre of mass that contains the body at any orientation.
MovingCore ball_around(const motion::BallisticMotion& motion, double t, const motion::Origin& O);

}  // namespace touchstone::fast::time_of_impact
