#include "fast/bounds/ballistic_box.h"

#include <variant>

#include "fast/bounds.h"
#include "fast/outward/displacement.h"
#include "fast/outward/duration.h"
#include "fast/outward/spun_ball.h"

namespace touchstone::fast {

using outward::unit;

Aabb ballistic_box(const Body& body, const Vec3& gravity, double duration) {
  outward::check_duration(duration);
  const std::optional<outward::SpunBall> ball = outward::spun_ball(body);
  if (!ball) return box(body);

  outward::Grower grower;
  if (ball->is_itself || body.velocity.w_WB.isZero(0))
    std::visit([&](const auto& shape) { grow(grower, shape, outward::motion(body.X_WB)); }, body.shape);
  else
    grow(grower, *ball, body.X_WB);
  Vec3 lo;
  Vec3 hi;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Interval moved = outward::displacement(body.velocity.v_WBcm[i] / unit, gravity[i] / unit, duration);
    lo[i] = moved.lo;
    hi[i] = moved.hi;
  }
  grower.stretch(lo, hi);
  return grower.box();
}

}  // namespace touchstone::fast
