#include "fast/motion/rigid_body_model.h"

#include <algorithm>

#include "fast/mass.h"
#include "fast/outward/centre_of_mass.h"
#include "fast/outward/outward.h"

namespace touchstone::fast::motion {
namespace {

/// A vertex is computed with turn_error and sums, and all lengths are ≤ reach + |c|: 40u covers them and the norm.
double farthest(const lin_canny::Solid& solid, const Vec3& c) {
  double radius = 0;
  for (const lin_canny::Convex& part : solid.parts()) {
    double core = 0;
    for (const Vec3& v : part.core.vertices()) {
      const Vec3 p = part.is_posed ? Vec3(part.R_BP * v + part.X_BP.p_WB) : v;
      core = std::max(core, (p - c).stableNorm());
    }
    const double rounding = part.is_posed || !c.isZero(0) ? 40 * u * (part.reach + c.stableNorm()) : 8 * u * core;
    radius = std::max(radius, (core + part.radius + rounding) * (1 + 2 * u));
  }
  return radius;
}

Turning turning_of(const Inertia& inertia) {
  if (!inertia.is_aligned) return Turning::tumbling;
  if (inertia.c.isZero(0)) return Turning::steady;
  return inertia.c.cwiseAbs().minCoeff() == 0 ? Turning::precessing : Turning::tumbling;
}

}  // namespace

RigidBodyModel::RigidBodyModel(const Body& body)
    : solid(body.shape), shape(body.shape), inertia(motion::inertia(body)) {
  const std::optional<MassProperties> known = fast::mass(body);
  is_fixed = !known.has_value();
  if (known) {
    mass = known->mass;
    I_BBcm_B = known->I_BBcm_B;
    const std::optional<outward::CentreOfMass> centre = outward::centre_of_mass(body);
    p_BBcm = centre->p_BBcm * outward::unit;
    if (!std::holds_alternative<MassProperties>(body.mass)) centre_error = 2 * centre->error * outward::unit;  // 2 > √3
    turning = turning_of(inertia);
    inertia.c.cwiseAbs().minCoeff(&axis);
  }
  radius = farthest(solid, p_BBcm) + 2 * centre_error;
}

}  // namespace touchstone::fast::motion
