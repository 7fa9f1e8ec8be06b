#include "oracle/truth/world_points.h"

#include <Eigen/Geometry>

#include "model/box_vertices.h"

namespace touchstone::oracle {
namespace {

Point placed(const Pose& X, const Point& p) {
  const Eigen::Quaternion<Real> q(X.q_WB.w, X.q_WB.x, X.q_WB.y, X.q_WB.z);
  return q.normalized() * p + X.p_WB.cast<Real>();
}

std::vector<Vec3> vertices(const Sphere&) { return {Vec3::Zero()}; }
std::vector<Vec3> vertices(const Box& box) { return vertices_of(box); }
std::vector<Vec3> vertices(const Polytope& polytope) { return polytope.vertices; }

bool has_part(const Compound& compound, int part) {
  return part >= 0 && part < static_cast<int>(compound.parts.size());
}

std::vector<Vec3> part_vertices(const Compound& compound, int part) {
  if (!has_part(compound, part)) return {};
  return std::visit([](const auto& shape) { return vertices(shape); },
                    compound.parts[static_cast<std::size_t>(part)].shape);
}
template <class Convex>
std::vector<Vec3> part_vertices(const Convex& shape, int part) {
  return part == 0 ? vertices(shape) : std::vector<Vec3>{};
}

}  // namespace

std::vector<Vec3> own_vertices(const Body& body, int part) {
  return std::visit([part](const auto& shape) { return part_vertices(shape, part); }, body.shape);
}

Points world_points(const Body& body, int part) {
  const auto* compound = std::get_if<Compound>(&body.shape);
  Points points;
  for (const Vec3& v : own_vertices(body, part)) {
    Point p = v.cast<Real>();
    if (compound != nullptr) p = placed(compound->parts[static_cast<std::size_t>(part)].X_BP, p);
    points.push_back(placed(body.X_WB, p));
  }
  return points;
}

}  // namespace touchstone::oracle
