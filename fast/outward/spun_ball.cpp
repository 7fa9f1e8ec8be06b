#include "fast/outward/spun_ball.h"

#include "fast/outward/centre_of_mass.h"
#include "fast/outward/reach.h"

namespace touchstone::fast::outward {

std::optional<SpunBall> spun_ball(const Body& body) {
  const std::optional<CentreOfMass> c = centre_of_mass(body);
  if (!c) return std::nullopt;
  SpunBall ball{c->p_BBcm, 0, c->least_mass, false};
  ball.is_itself = std::holds_alternative<Sphere>(body.shape) && c->p_BBcm.isZero(0);
  // ‖c − c*‖ ≤ √3 error < 2 error.
  ball.radius = (reach(body.shape, ball.centre) + 4 * c->error) * (1 + 2 * u);
  return ball;
}

void grow(Grower& grower, const SpunBall& ball, const Pose& X_WB) {
  grower.add(motion(X_WB), ball.centre, Vec3::Constant(ball.radius), ball.centre.lpNorm<1>() + ball.radius);
}

}  // namespace touchstone::fast::outward
