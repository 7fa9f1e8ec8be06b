#include "reference/impulse/impact.h"

#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "model/input_error.h"
#include "reference/exact/linear.h"
#include "reference/motion/moving_mass.h"

namespace touchstone::reference {
namespace {

Response response(const Body& body, const MovingMass& mass, const Triple& p_WC) {
  const Motion X_WB = motion(body.X_WB);
  Response result;
  result.inverse_mass = 1 / mass.mass;
  const std::array<Triple, 3> inverse = inverted(mass.inertia);
  for (std::size_t i = 0; i < 3; ++i) {
    const Triple row = times(inverse, X_WB.rows[i]);  // (R I⁻¹ Rᵀ)ij = (I⁻¹ Rᵢᵀ)·Rⱼ
    for (std::size_t j = 0; j < 3; ++j) result.inverse_inertia[i][j] = dot(row, X_WB.rows[j]);
  }
  result.arm = minus(p_WC, X_WB(mass.centre));
  return result;
}

/// A fixed body does not respond to an impulse. The scene gives the velocity of its origin, which takes the place of a
/// centre of mass.
Response fixed(const Body& body, const Triple& p_WC) {
  Response result;
  result.arm = minus(p_WC, triple(body.X_WB.p_WB));
  return result;
}

Triple velocity_at_C(const Body& body, const Response& response) {
  return plus(triple(body.velocity.v_WBcm), cross(triple(body.velocity.w_WB), response.arm));
}

}  // namespace

Triple Response::linear(const Triple& P) const { return scaled(inverse_mass, P); }
Triple Response::angular(const Triple& P) const { return times(inverse_inertia, cross(arm, P)); }

Impact impact(const Scene& scene) {
  if (!scene.contact) throw InputError("contact", "missing; expected one for a question about an impact");
  const Contact& contact = *scene.contact;
  Impact result;
  const Triple p_WC = triple(contact.p_WC);
  for (std::size_t b = 0; b < 2; ++b) {
    const Body& body = scene.bodies[b];
    if (std::holds_alternative<Fixed>(body.mass)) {
      result.bodies[b] = fixed(body, p_WC);
      continue;
    }
    const MovingMass weight = moving_mass(body, "bodies[" + std::to_string(b) + "]");
    result.pi = result.pi || weight.pi;
    result.bodies[b] = response(body, weight, p_WC);
  }
  result.u0 = minus(velocity_at_C(scene.bodies[0], result.bodies[0]), velocity_at_C(scene.bodies[1], result.bodies[1]));
  for (std::size_t j = 0; j < 3; ++j) {
    Triple axis;
    axis[j] = 1;
    for (const Response& body : result.bodies) {
      const Triple column = plus(body.linear(axis), cross(body.angular(axis), body.arm));
      for (std::size_t i = 0; i < 3; ++i) result.K[i][j] += column[i];
    }
  }
  result.N = triple(contact.nhat_BA_W);
  result.law = contact.law;
  result.e = mpq_class(contact.restitution);
  if (!std::isinf(contact.friction)) result.mu = mpq_class(contact.friction);
  return result;
}

}  // namespace touchstone::reference
