#include "oracle/truth/world_points.h"

#include <Eigen/Geometry>

#include "model/box_vertices.h"

namespace touchstone::oracle {
namespace {

Point placed(const Pose& X, const Point& p) {
  const Eigen::Quaternion<Real> q(X.q_WB.w, X.q_WB.x, X.q_WB.y, X.q_WB.z);
  return q.normalized() * p + X.p_WB.cast<Real>();
}

Points vertices(const Sphere&) { return {Point::Zero()}; }
Points points(const std::vector<Vec3>& vertices) {
  Points cast;
  for (const Vec3& v : vertices) cast.push_back(v.cast<Real>());
  return cast;
}
Points vertices(const Box& box) { return points(vertices_of(box)); }
Points vertices(const Polytope& polytope) { return points(polytope.vertices); }

Points part_points(const Compound& compound, int part) {
  if (part < 0 || part >= static_cast<int>(compound.parts.size())) return {};
  const Part& chosen = compound.parts[static_cast<std::size_t>(part)];
  Points points = std::visit([](const auto& shape) { return vertices(shape); }, chosen.shape);
  for (Point& p : points) p = placed(chosen.X_BP, p);
  return points;
}
template <class Convex>
Points part_points(const Convex& shape, int part) {
  return part == 0 ? vertices(shape) : Points{};
}

}  // namespace

Points world_points(const Body& body, int part) {
  Points points = std::visit([part](const auto& shape) { return part_points(shape, part); }, body.shape);
  for (Point& p : points) p = placed(body.X_WB, p);
  return points;
}

}  // namespace touchstone::oracle
