#include "fast/time_of_impact/side.h"

#include <algorithm>

namespace touchstone::fast::meeting {

using lin_canny::Convex;

/// To the stand's turn error come 6u of a computed R v, and 28u of R_WB R_BP; the part's own place is turned once more
/// (24u with its sums). A velocity w × r rounds by 8u |w||r|, r itself by the placement's error; n·v by 4u |v|; p̈ by as
/// much again for each w in it, and for α, a product of two of them. A push over mass is known to 64u.
Side side(const motion::Flight& flight, std::size_t part, double t, const motion::Origin& O) {
  const motion::Flyer& body = flight.flyer();
  const Convex& convex = body.solid.parts()[part];
  const motion::Stand now = flight.stand(t, O);
  Side s;
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
                  reach * (now.w_error + (s.core.turn_error + 16 * u) * flight.rate());
  s.acceleration = flight.acceleration() - O.a_WO;
  s.alpha = now.alpha_WB;
  s.swirl = flight.curl() * reach;
  s.bend_error = s.swirl * (4 * s.core.turn_error + 64 * u) + 4 * flight.rate() * now.w_error * reach +
                 128 * u * s.acceleration.lpNorm<1>();
  s.whirl = flight.whirl() * reach;
  return s;
}

Side ball_around(const motion::Flight& flight, double t, const motion::Origin& O) {
  static const lin_canny::Hull point(Vec3::Zero());
  const motion::Centre centre = flight.centre(t, O);
  Side s;
  s.core.hull = &point;
  s.core.t = centre.p_WOBcm;
  s.core.turn_error = 0;
  s.core.shift_error = centre.error + 2 * u * s.core.t.lpNorm<1>();
  s.radius = flight.flyer().radius;
  s.v = centre.v_WBcm;
  s.slope_error = centre.v_error + 4 * u * s.v.lpNorm<1>();
  s.acceleration = flight.acceleration() - O.a_WO;
  s.bend_error = 128 * u * s.acceleration.lpNorm<1>();
  return s;
}

}  // namespace touchstone::fast::meeting
