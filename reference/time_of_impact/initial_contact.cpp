#include "reference/time_of_impact/initial_contact.h"

#include <algorithm>
#include <utility>

#include "reference/distance/common_points.h"
#include "reference/distance/routes.h"
#include "reference/distance/touching_only.h"
#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/hull/faces.h"

namespace touchstone::reference {

std::vector<Triple> vertices_at_start(const Body& body, int part) {
  const Motion X_WP = composed(motion(body.X_WB), motion(part_pose(body, part)));
  std::vector<Triple> placed;
  for (const Vec3& v : core_of(body, part).vertices) placed.push_back(X_WP(triple(v)));
  return placed;
}

namespace {

using Kind = InitialContact::Kind;

/// The part as vertices, edges and half-spaces in W, translated by `shift`.
Hull hull(const Body& body, int part, const Triple& shift) {
  const Core core = core_of(body, part);
  std::vector<Triple> placed = vertices_at_start(body, part);
  for (Triple& v : placed) v = plus(v, shift);
  Hull result;
  const auto at = [&](int v) -> const Triple& { return placed[static_cast<std::size_t>(v)]; };
  for (const Edge& edge : edges_of(*core.faces)) result.edges.push_back({at(edge.tail), at(edge.head)});
  for (const std::vector<int>& face : *core.faces) {
    Triple normal;
    for (std::size_t k = 2; k < face.size(); ++k) {
      normal = plus(normal, cross(minus(at(face[k - 1]), at(face[0])), minus(at(face[k]), at(face[0]))));
    }
    result.sides.push_back({normal, dot(normal, at(face[0]))});
  }
  return result;
}

/// The extreme rays of the cone of normals, and perhaps some more.
std::vector<Triple> normals(const PosedPair& pair, const CoreNearest& nearest, const Triple& d) {
  if (nearest.cores == Verdict::separated) return {d};
  const RoundUpward rounding;
  std::vector<Triple> rays;
  for (const IntegerVec& n : separating_normals(pair, nearest.pairs)) rays.push_back({n.x, n.y, n.z});
  return rays;
}

/// Minimax over separating normals and contact points: do the bodies approach, separate, or is it neither?
void classify(InitialContact& initial, const std::vector<Triple>& normals, const std::vector<Triple>& points,
              const Triple& d, const BallisticStart& a, const BallisticStart& b) {
  const auto speed = [&](const Triple& n, const Triple& x) {
    return sgn(mpq_class(dot(n, minus(velocity(a, x), velocity(b, minus(x, d))))));
  };
  initial.kind = Kind::neither;
  initial.n = normals[0];
  initial.x = points[0];
  const auto good = std::ranges::find_if(normals, [&](const Triple& n) {
    return std::ranges::all_of(points, [&](const Triple& x) { return speed(n, x) > 0; });
  });
  const auto bad = std::ranges::find_if(points, [&](const Triple& x) {
    return std::ranges::all_of(normals, [&](const Triple& n) { return speed(n, x) < 0; });
  });
  if (good != normals.end()) {
    initial.kind = Kind::separating;
    initial.n = *good;
  } else if (bad != points.end()) {
    initial.kind = Kind::approaching;
    initial.x = *bad;
  }
  initial.y = minus(initial.x, d);
}

std::vector<bool> on_plane(const std::vector<Triple>& vertices, const Triple& n, const Triple& x) {
  std::vector<bool> on;
  for (const Triple& v : vertices) on.push_back(dot(n, minus(v, x)) == 0);
  return on;
}

}  // namespace

Triple velocity(const BallisticStart& body, const Triple& at) { return plus(body.v, cross(body.w, minus(at, body.p))); }

std::vector<Triple> closest_points_on_A(const Body& A, int part_A, const Body& B, int part_B, const Triple& d) {
  const std::vector<Triple> a = vertices_at_start(A, part_A), b = vertices_at_start(B, part_B);
  if (a.size() == 1) return a;
  if (b.size() == 1) return {plus(b[0], d)};
  return common_points(hull(A, part_A, {}), hull(B, part_B, d));
}

InitialContact initial_contact(const Body& A, int part_A, const BallisticStart& a, const Body& B, int part_B,
                               const BallisticStart& b, double apart) {
  InitialContact result;
  PosedPair pair(A, part_A, B, part_B);
  const CoreNearest nearest = nearest_certified(pair);
  const mpq_class r = mpq_class(pair.A.radius()) + mpq_class(pair.B.radius()) + mpq_class(apart);
  const mpq_class excess = value_of(squared_distance(pair, nearest)) - r * r;
  if (excess > 0) return result;
  result.kind = Kind::overlapping;
  if (excess < 0 || nearest.cores == Verdict::overlapping) return result;
  const mpq_class factor = value_of(pair.length(nearest.height, nearest.denominator));
  const Triple d = scaled(factor, Triple{nearest.normal.x, nearest.normal.y, nearest.normal.z});
  result.normals = normals(pair, nearest, d);
  classify(result, result.normals, closest_points_on_A(A, part_A, B, part_B, d), d, a, b);
  result.on_A = on_plane(vertices_at_start(A, part_A), result.n, result.x);
  result.on_B = on_plane(vertices_at_start(B, part_B), result.n, result.y);
  return result;
}

}  // namespace touchstone::reference
