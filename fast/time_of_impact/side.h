// One convex part of a flying body at one time, with what bounds its motion from then on.
#pragma once

#include "fast/lin_canny/placed.h"
#include "fast/motion/flight.h"

namespace touchstone::fast::meeting {

/// For a point at r from the centre of mass, in W: it stands within the placement's errors, moves at v + w × r (w
/// within w_error, v within v_error), and |p̈ − acceleration| ≤ curl |r|.
struct Side {
  lin_canny::Placed core;            ///< in the pair's frame; its errors hold the flight's
  double radius = 0;                 ///< m; by which the part is swollen around its core
  Vec3 arm = Vec3::Zero();           ///< m; from the centre of mass to the core's origin
  Vec3 v = Vec3::Zero();             ///< m/s; of the centre of mass, seen from O
  Vec3 w = Vec3::Zero();             ///< rad/s
  double slope_error = 0;            ///< m/s; of n·velocity of any core point, |n| = 1
  Vec3 acceleration = Vec3::Zero();  ///< m/s²; likewise
  Vec3 alpha = Vec3::Zero();         ///< rad/s²
  double swirl = 0;                  ///< m/s²; ≥ |p̈ − acceleration| of all core points, at all times
  double bend_error = 0;             ///< m/s²; of n·p̈ as computed from w and alpha
  double whirl = 0;                  ///< m/s³; ≥ the third derivative's length, of all core points, at all times
};

/// Part `part` of the flight's body at time t, in W's axes, seen from O.
Side side(const motion::Flight& flight, std::size_t part, double t, const motion::Origin& O);

/// The ball around its centre of mass in which the body stays, however it turns.
Side ball_around(const motion::Flight& flight, double t, const motion::Origin& O);

}  // namespace touchstone::fast::meeting
