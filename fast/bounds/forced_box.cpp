#include "fast/bounds/forced_box.h"

#include <limits>

#include "fast/bounds.h"
#include "fast/outward/displacement.h"
#include "fast/outward/duration.h"
#include "fast/outward/spun_ball.h"

namespace touchstone::fast {

using outward::unit;

Aabb forced_box(const Body& body, const Vec3& gravity, double duration, double greatest_force) {
  outward::check_duration(duration);
  if (!(greatest_force >= 0 && greatest_force <= std::numeric_limits<double>::max()))
    throw InputError("greatest_force", "must be a finite number of newtons, >= 0");
  const std::optional<outward::SpunBall> ball = outward::spun_ball(body);
  if (!ball) return box(body);

  outward::Grower grower;
  grow(grower, *ball, body.X_WB);
  // The quotient, the change of unit and the sum with g round by 3u together; they round outward.
  const double f = greatest_force / ball->least_mass / unit * (1 + 4 * u);
  Vec3 lo;
  Vec3 hi;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double v = body.velocity.v_WBcm[i] / unit;
    const double g = gravity[i] / unit;
    const double step = 2 * u * (std::abs(g) + f);
    lo[i] = outward::displacement(v, (g - f) - step, duration).lo;
    hi[i] = outward::displacement(v, (g + f) + step, duration).hi;
  }
  grower.stretch(lo, hi);
  return grower.box();
}

}  // namespace touchstone::fast
