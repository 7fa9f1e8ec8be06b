#include "fast/bounds/fixed_cube.h"

#include "fast/bounds.h"
#include "fast/outward/outward.h"
#include "fast/outward/reach.h"

namespace touchstone::fast {
namespace {

Vec3 middle(const Shape& shape) {
  Body at_origin;
  at_origin.shape = shape;
  const Aabb own = box(at_origin);
  return own.lo / (2 * outward::unit) + own.hi / (2 * outward::unit);
}

}  // namespace

FixedCube::FixedCube(const Shape& shape) : centre_(middle(shape)), radius_(outward::reach(shape, centre_)) {}

Aabb FixedCube::at(const Pose& X_WB) const {
  outward::Grower grower;
  grower.add(outward::motion(X_WB), centre_, Vec3::Constant(radius_), centre_.lpNorm<1>() + radius_);
  return grower.box();
}

}  // namespace touchstone::fast
