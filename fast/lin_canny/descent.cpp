#include "fast/lin_canny/descent.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fast/lin_canny/facing.h"
#include "fast/mark.h"

namespace touchstone::fast::lin_canny {
namespace {

bool has(const Simplex& simplex, const VertexDifference& difference) {
  return std::any_of(simplex.points.begin(), simplex.points.begin() + simplex.size,
                     [&](const VertexDifference& p) { return p.a == difference.a && p.b == difference.b; });
}

/// The vertices of one hull in a simplex, each once, with their weights.
struct Support {
  std::array<int, 4> vertices{};
  std::array<double, 4> weights{};
  int count = 0;

  void add(int vertex, double weight) {
    std::size_t i = 0;
    while (i < static_cast<std::size_t>(count) && vertices[i] != vertex) ++i;
    if (i == static_cast<std::size_t>(count)) vertices[static_cast<std::size_t>(count++)] = vertex;
    weights[i] += weight;
  }
};

/// `side`: the vertices of A, or those of B.
Support support(const Simplex& simplex, int VertexDifference::*side) {
  Support found;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.size); ++i) {
    found.add(simplex.points[i].*side, simplex.weights[i]);
  }
  return found;
}

const Vec3& corner(const Hull& hull, const Support& of, std::size_t i) { return hull.vertex(of.vertices[i]); }

/// In the pair's frame.
Vec3 combined(const PosedHull& P, const Support& of) {
  const Hull& hull = *P.hull;
  const Vec3& o = corner(hull, of, 0);
  if (of.count == 1) return P.out(o);
  const double sum = of.weights[0] + of.weights[1] + of.weights[2];
  const double at_1 = std::min(of.weights[1] / sum, 1.0), at_2 = std::min(of.weights[2] / sum, 1 - at_1);
  const Vec3 second = of.count == 3 ? Vec3(at_2 * (corner(hull, of, 2) - o)) : Vec3(Vec3::Zero());
  return P.out(o + (at_1 * (corner(hull, of, 1) - o) + second));
}

/// Of length 1, or 0 if v is too short to be measured.
Vec3 unit_or_zero(const Vec3& v) {
  const double squared = v.squaredNorm();
  return squared > 0x1p-900 && squared < 0x1p900 ? Vec3(v / std::sqrt(squared)) : Vec3(Vec3::Zero());
}

Vec3 normal_of(const Hull& hull, const Support& face) {
  const Vec3& o = corner(hull, face, 0);
  return unit_or_zero(unit_or_zero(corner(hull, face, 1) - o).cross(unit_or_zero(corner(hull, face, 2) - o)));
}

/// The unit vector along the feature's edge, in the pair's frame.
Vec3 edge_of(const PosedHull& P, const Support& edge) {
  return P.turned_out(unit_or_zero(corner(*P.hull, edge, 1) - corner(*P.hull, edge, 0)));
}

/// v without its component along e, which is of length 1 or 0.
Vec3 across_unit(const Vec3& v, const Vec3& e) { return v - e * v.dot(e); }

/// Perpendicular to both features; either way round.
Vec3 perpendicular(const PosedHull& A, const Support& in_A, const PosedHull& B, const Support& in_B, const Vec3& d) {
  if (in_A.count == 3) return A.turned_out(normal_of(*A.hull, in_A));
  if (in_B.count == 3) return B.turned_out(normal_of(*B.hull, in_B));
  const Vec3 e = in_A.count == 2 ? edge_of(A, in_A) : Vec3(Vec3::Zero());
  const Vec3 f = in_B.count == 2 ? edge_of(B, in_B) : Vec3(Vec3::Zero());
  const Vec3 n = e.cross(f);
  return n.squaredNorm() > clearly_crossing ? n : across_unit(across_unit(d, e), f);
}

}  // namespace

Simplex descend(const PosedHull& A, const PosedHull& B, double rounding_error) {
  mark(Mark::descent);
  Simplex held(lowest(A, B, B.t - A.t));
  for (int i = 0; i < most_vertices; ++i) {
    Vec3 toward;
    if (!reduce(held, toward) || held.size == 4) return held;
    const VertexDifference next = lowest(A, B, toward);
    const bool is_lower = toward.dot(held.w(0) - next.w) > rounding_error / 8 * toward.norm();
    if (!is_lower || has(held, next)) return held;
    held.add(next);
    mark(Mark::descent_step);
  }
  return held;
}

Bracket bracket(const PosedHull& A, const PosedHull& B, const Simplex& nearest, double rounding_error) {
  const Support in_A = support(nearest, &VertexDifference::a), in_B = support(nearest, &VertexDifference::b);
  Bracket found;
  found.a = combined(A, in_A);
  found.b = combined(B, in_B);
  const Vec3 d = found.b - found.a;
  found.length = d.norm();
  found.rounding = rounding_error;
  found.hi = found.length * (1 + 4 * u) + error_of_hi(A, B, rounding_error);
  const auto try_direction = [&](const Vec3& along) {
    Vec3 n = unit_or_zero(along);
    if (n.isZero(0)) return;
    if (n.dot(d) < 0) n = -n;
    const double up_to_A = greatest_height(*A.hull, A.turned_in(n)),
                 up_to_B = greatest_height(*B.hull, B.turned_in(-n));
    const double lo = gap_between(A, B, n, up_to_A, up_to_B, rounding_error);
    if (!found.n.isZero(0) && lo <= found.lo) return;
    found.n = n;
    found.lo = lo;
  };
  try_direction(perpendicular(A, in_A, B, in_B, d));
  if (is_explained_by_rounding(found)) return found;
  if (in_B.count == 3) try_direction(B.turned_out(normal_of(*B.hull, in_B)));
  if (in_A.count == 2) try_direction(across_unit(d, edge_of(A, in_A)));
  if (in_B.count == 2) try_direction(across_unit(d, edge_of(B, in_B)));
  try_direction(d);
  return found;
}

std::vector<int> closest_vertices(const PosedHull& P, const Vec3& n, const Simplex& nearest,
                                  int VertexDifference::*side) {
  const Hull& hull = *P.hull;
  const Vec3 direction = P.turned_in(n);
  const double level = greatest_height(hull, direction) - 2 * (P.turn_error + 7 * u) * hull.radius();
  std::vector<int> vertices;
  vertices.reserve(4);
  for (int v = 0; v < hull.vertex_count(); ++v) {
    const bool is_held = std::any_of(nearest.points.begin(), nearest.points.begin() + nearest.size,
                                     [&](const VertexDifference& point) { return point.*side == v; });
    if (is_held || direction.dot(hull.vertex(v)) >= level) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace touchstone::fast::lin_canny
