// Turns a pair so that its normal is the z axis and the gap (or depth) is in a translation of its own. The solids can
// then be rounded to few bits while the gap, however small, stays.
#include <Eigen/Geometry>
#include <cmath>

#include "model/sequence.h"
#include "oracle/minimise/scene_edit.h"
#include "oracle/minimise/shrink.h"
#include "oracle/truth/truth.h"
#include "oracle/truth/world_points.h"

namespace touchstone::oracle::shrink {
namespace {

/// Unit vector from A to B: along the exact distance or the exact separating direction. None for bodies that touch or
/// are compounds.
std::optional<Point> normal(const Scene& scene) {
  if (scene.bodies.size() != 2) return std::nullopt;
  for (const Body& body : scene.bodies) {
    if (!std::holds_alternative<Box>(body.shape) && !std::holds_alternative<Polytope>(body.shape)) return std::nullopt;
  }
  reference::RationalVec3 n = truth::distance(scene).difference;
  if (n == reference::RationalVec3{}) n = truth::penetration(scene).direction;
  const Point from_B(n.x.nearest(), n.y.nearest(), n.z.nearest());
  const Real length = from_B.stableNorm();
  if (!(length > 0)) return std::nullopt;
  return -from_B / length;
}

/// Rows: two directions perpendicular to n, then n.
Eigen::Matrix<Real, 3, 3> frame_with_z(const Point& n) {
  Eigen::Index least = 0;
  n.cwiseAbs().minCoeff(&least);
  Eigen::Matrix<Real, 3, 3> rows;
  rows.row(0) = n.cross(Point::Unit(least)).normalized();
  rows.row(1) = n.cross(Point(rows.row(0)));
  rows.row(2) = n;
  return rows;
}

double rounded(Real x, int bits, int exponent_of_all) {
  const int exponent = bits - 1 - exponent_of_all;
  return static_cast<double>(std::ldexp(std::nearbyint(std::ldexp(x, exponent)), -exponent));
}

Real extreme_along(const Points& points, const Point& n, bool greatest) {
  Real most = n.dot(points.front());
  for (const Point& p : points) most = greatest ? std::max(most, n.dot(p)) : std::min(most, n.dot(p));
  return most;
}

/// Rounds the solids to `bits` and the gap to `gap_bits`.
std::optional<Scene> facing(const Scene& before, int bits, int gap_bits) {
  const std::optional<Point> n = normal(before);
  if (!n) return std::nullopt;
  const Eigen::Matrix<Real, 3, 3> R = frame_with_z(*n);
  const Points A = world_points(before.bodies[0], 0);
  const Points B = world_points(before.bodies[1], 0);
  const Real top = extreme_along(A, *n, true);
  const Real bottom = extreme_along(B, *n, false);
  const Real gap = bottom - top;
  const Point middle = A.front() - (n->dot(A.front()) - top) * *n;  // in the plane of A's highest feature
  Real size = 0;
  for (const Points& points : {A, B}) {
    for (const Point& p : points) size = std::max(size, (p - middle).cwiseAbs().maxCoeff());
  }
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  const auto solid = [&](const Points& points, Real lifted) {
    Polytope polytope;
    for (const Point& p : points) {
      const Point local = R * (p - middle) - lifted * Point::UnitZ();
      Vec3 v;
      for (int i = 0; i < 3; ++i) v[i] = rounded(local[i], bits, std::ilogb(size));
      polytope.vertices.push_back(v);
    }
    return polytope;
  };
  Scene scene = before;
  for (Body& body : scene.bodies) body.X_WB = {};
  scene.bodies[0].shape = solid(A, 0);
  scene.bodies[1].shape = solid(B, gap);
  if (gap != 0) scene.bodies[1].X_WB.p_WB.z() = rounded(gap, gap_bits, std::ilogb(gap));
  return scene;
}

}  // namespace

std::vector<Move> facing_along_z(const Scene& scene) {
  if (is_sequence(scene) || scene.contact) return {};
  std::vector<Move> moves;
  for (const int bits : {1, 2, 3, 4, 5, 6, 8, 12, 20}) {
    for (const int gap_bits : {1, 3}) {
      moves.push_back([=](const Scene& s) { return facing(s, bits, gap_bits); });
    }
  }
  return moves;
}

}  // namespace touchstone::oracle::shrink
