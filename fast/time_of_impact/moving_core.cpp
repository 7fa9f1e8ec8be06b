#include "fast/time_of_impact/moving_core.h"

#include <algorithm>

namespace touchstone::fast::time_of_impact {

using lin_canny::Convex;

/// The rotation's turn error grows by 6u for a computed R v, and by 28u for R_WB R_BP; the part's own position is
/// rotated once more (24u with its sums). A velocity w × r rounds by 8u |w||r|, where r has the position's error; n·v
/// by 4u |v|; p̈ by as much again for each w in it, and for α, a product of two of them. Force over mass is known to
/// 64u.
MovingCore moving_core(const motion::BallisticMotion& motion, std::size_t part, double t, const motion::Origin& O) {
  const motion::RigidBodyModel& body = motion.model();
  const Convex& convex = body.solid.parts()[part];
  const motion::Kinematics now = motion.kinematics(t, O);
  MovingCore s;
  s.core.hull = &convex.core;
  s.core.R = convex.is_posed ? Mat3(now.R_WB.lazyProduct(convex.R_BP)) : now.R_WB;
  s.core.turn_error = now.turn_error + (convex.is_posed ? 34 : 6) * u;
  const Vec3 arm = convex.is_posed ? Vec3(convex.X_BP.p_WB - body.p_BBcm) : Vec3(-body.p_BBcm);
  const double arm_length = arm.lpNorm<1>();
  if (arm_length > 0) s.arm = now.R_WB * arm;
  s.core.t = now.centre.p_WOBcm + s.arm;
  s.core.shift_error = now.centre.error + (now.turn_error + 24 * u) * arm_length + 2 * u * s.core.t.lpNorm<1>();
  s.radius = convex.radius;
  s.v = now.centre.v_WBcm;
  s.w = now.w_WB;
  const double reach = std::min(body.radius, (arm_length + convex.core.radius()) * (1 + 8 * u));
  s.slope_error = now.centre.v_error + 4 * u * s.v.lpNorm<1>() +
                  reach * (now.w_error + (s.core.turn_error + 16 * u) * motion.rate());
  s.acceleration = motion.acceleration() - O.a_WO;
  s.alpha = now.alpha_WB;
  s.acceleration_bound = motion.acceleration_per_radius() * reach;
  s.bend_error = s.acceleration_bound * (4 * s.core.turn_error + 64 * u) + 4 * motion.rate() * now.w_error * reach +
                 128 * u * s.acceleration.lpNorm<1>();
  s.jerk_bound = motion.jerk_per_radius() * reach;
  return s;
}

MovingCore ball_around(const motion::BallisticMotion& motion, double t, const motion::Origin& O) {
  static const lin_canny::Hull point(Vec3::Zero());
  const motion::Centre centre = motion.centre(t, O);
  MovingCore s;
  s.core.hull = &point;
  s.core.t = centre.p_WOBcm;
  s.core.turn_error = 0;
  s.core.shift_error = centre.error + 2 * u * s.core.t.lpNorm<1>();
  s.radius = motion.model().radius;
  s.v = centre.v_WBcm;
  s.slope_error = centre.v_error + 4 * u * s.v.lpNorm<1>();
  s.acceleration = motion.acceleration() - O.a_WO;
  s.bend_error = 128 * u * s.acceleration.lpNorm<1>();
  return s;
}

}  // namespace touchstone::fast::time_of_impact
