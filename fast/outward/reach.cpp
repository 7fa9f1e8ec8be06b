#include "fast/outward/reach.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "fast/outward/outward.h"
#include "model/box_vertices.h"

namespace touchstone::fast::outward {
namespace {

/// For one point R p + t at a distance from the centre c, |error| ≤ √3 (place_error + u |p_i − c_i|) plus the rounding
/// of the length: divisions, squares, two sums, a root and a product round by < 8u of it. With |p − c| ≤ ‖p‖₁ + |t|₁ +
/// |c|₁ = m that is < 28u m + 10u m for a posed part and 10u m for a body's own points.
double from(const Vec3& centre, const Motion& X, const Vec3& p, double length) {
  const Vec3 d = X.R * p + X.t - centre;
  const double distance = std::hypot(d.x(), d.y(), d.z());
  return distance * (1 + 12 * u) + 2 * (place_error(X, length) + u * centre.lpNorm<1>());
}

double reach_of(const Sphere& sphere, const Motion& X, const Vec3& centre) {
  const double radius = sphere.radius / unit;
  return (from(centre, X, Vec3::Zero(), 0) + radius) * (1 + 2 * u);
}

double reach_of(const Box& box, const Motion& X, const Vec3& centre) {
  double greatest = 0;
  for (const Vec3& p : vertices_of({box.half_extents / unit})) {
    greatest = std::max(greatest, from(centre, X, p, p.lpNorm<1>()));
  }
  return greatest;
}

double reach_of(const Polytope& polytope, const Motion& X, const Vec3& centre) {
  double greatest = 0;
  for (const Vec3& vertex : polytope.vertices) {
    const Vec3 p = vertex / unit;
    greatest = std::max(greatest, from(centre, X, p, p.lpNorm<1>()));
  }
  return greatest;
}

double reach_of(const Compound& compound, const Motion&, const Vec3& centre) {
  double greatest = 0;
  for (const Part& part : compound.parts) {
    const Motion X = motion(part.X_BP);
    greatest = std::max(greatest, std::visit([&](const auto& s) { return reach_of(s, X, centre); }, part.shape));
  }
  return greatest;
}

}  // namespace

double reach(const Shape& shape, const Vec3& centre) {
  return std::visit([&](const auto& s) { return reach_of(s, Motion{}, centre); }, shape);
}

}  // namespace touchstone::fast::outward
