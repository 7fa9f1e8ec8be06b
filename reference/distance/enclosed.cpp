// Bounds on a distance in long doubles. GJK guesses the closest vertices, wherever it ends; then
//   the upper bound is the length of a convex combination of differences of vertices;
//   the lower bound is the gap between two parallel planes, tested with all vertices;
//   an overlap is proved by a tetrahedron of four differences, with 0 inside it.
// A wrong guess makes the bounds wide, never wrong. NaN and infinity prove nothing: every comparison with them fails.
//
// Rounding, with u = 2^-64 (x86) and L = |t| + the reach of both bodies and their radii, t = p_WB − p_WA:
//   A vertex in the frame of its body: the entries of R(q/|q|) as in fast/lin_canny/rotation.h, 12u|v|; the product
//   5.2u|v|; of a part again the same and a sum, together < 40uL. t itself u|t|, and the sum 1.8uL: < 43uL.
//   A difference of two vertices: 86uL, and 1.8uL of its own: < 88uL.
//   The length of Σ weight·w / Σ weight, weights > 0: at most 4 products and 3 sums, the sum of the weights, quotient:
//   8u of L; the root 3uL: with the error of w < 100uL.
//   The gap n·(a − b)/|n|: 3.1u|a| and 3.1u|b|, the norm 3uL, quotient and difference 2uL: < 9uL; with the errors of a
//   and b < 100uL.
//   A determinant of three differences w, |w| ≤ M: errors of w 3M²·88uL and terms of second order; its own 6 products
//   and sums of terms ≤ M³: 32uM³. With M ≤ 2L: < 4M²·100uL + 32uM³.
// Lengths have the exponents of doubles, so no product of six of them leaves the range of long doubles, and underflow
// is far below uL.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "model/box_vertices.h"
#include "model/infinity.h"
#include "reference/distance/guess.h"
#include "reference/enclosed_distance.h"

namespace touchstone::reference {

namespace in_long_doubles {

using Real = long double;
using Point = Coordinates<Real>;
using Points = std::vector<Point>;

constexpr Real u = std::numeric_limits<Real>::epsilon() / 2;
constexpr Real error_of_bound = 100 * u;  ///< times L

/// Long doubles that are no longer than doubles prove nothing that is worth it.
constexpr bool is_long = std::numeric_limits<Real>::is_iec559 && std::numeric_limits<Real>::digits >= 64;

struct Rotation {
  Point x, y, z;  ///< rows

  Point of(const Point& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};

Rotation rotation(const Quaternion& q) {
  const Real w = q.w;
  const Real x = q.x;
  const Real y = q.y;
  const Real z = q.z;
  const Real s = 1 / ((w * w + x * x) + (y * y + z * z));
  return {{((w * w + x * x) - (y * y + z * z)) * s, 2 * (x * y - w * z) * s, 2 * (x * z + w * y) * s},
          {2 * (x * y + w * z) * s, ((w * w + y * y) - (x * x + z * z)) * s, 2 * (y * z - w * x) * s},
          {2 * (x * z - w * y) * s, 2 * (y * z + w * x) * s, ((w * w + z * z) - (x * x + y * y)) * s}};
}

Point point(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Real length(const Point& v) { return std::sqrt(dot(v, v)); }

/// A convex part: its vertices, and the radius by which it is swollen.
struct PosedPart {
  Points points;
  Real radius = 0;
};

PosedPart part_of(const ConvexShape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return {{{0, 0, 0}}, sphere->radius};
  PosedPart part;
  const auto add = [&](const std::vector<Vec3>& vertices) {
    part.points.reserve(vertices.size());
    for (const Vec3& v : vertices) part.points.push_back(point(v));
  };
  if (const auto* box = std::get_if<Box>(&shape)) add(vertices_of(*box));
  if (const auto* polytope = std::get_if<Polytope>(&shape)) add(polytope->vertices);
  return part;
}

/// Moves the points by a pose whose translation is `t`. Returns their reach: |t| + the greatest |v|.
Real move(PosedPart& part, const Quaternion& q, const Point& t) {
  const Rotation R = rotation(q);
  Real reach = 0;
  for (Point& p : part.points) {
    reach = std::max(reach, length(p));
    p = R.of(p) + t;
  }
  return reach + length(t);
}

struct PosedBody {
  std::vector<PosedPart> parts;
  Real reach = 0;  ///< |t| + the reach of its points and radii from its origin
};

PosedBody posed(const Body& body, const Point& t) {
  PosedBody posed;
  const auto add = [&](PosedPart part, Real reach) {
    const Real moved = move(part, body.X_WB.q_WB, t);
    posed.reach = std::max({posed.reach, moved, reach + length(t)}) + part.radius;
    posed.parts.push_back(std::move(part));
  };
  if (const auto* compound = std::get_if<Compound>(&body.shape)) {
    for (const Part& part : compound->parts) {
      PosedPart inner = part_of(part.shape);
      const Real reach = move(inner, part.X_BP.q_WB, point(part.X_BP.p_WB));
      add(std::move(inner), reach);
    }
  }
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) add(part_of(*sphere), 0);
  if (const auto* box = std::get_if<Box>(&body.shape)) add(part_of(*box), 0);
  if (const auto* polytope = std::get_if<Polytope>(&body.shape)) add(part_of(*polytope), 0);
  return posed;
}

/// Of two cores; lo < 0 proves nothing.
struct Bounds {
  Real lo = -1;
  Real hi = std::numeric_limits<Real>::infinity();
  bool overlap = false;  ///< 0 is inside A − B
};

/// An edge's direction is improved once, so that it is perpendicular to the edge within rounding of the edge, not of
/// the distance to it.
Point direction(const std::vector<Point>& w, const NearestPoint<Real>& y) {
  if (y.count != 2) return y.direction;
  const auto member = [&](std::size_t i) { return w[static_cast<std::size_t>(y.members[i])]; };
  const Point e = member(1) - member(0);
  return y.direction - Real(dot(y.direction, e) / dot(e, e)) * e;
}

bool is_inside(const std::vector<Point>& w, const NearestPoint<Real>& y, Real L) {
  if (y.count != 4) return false;
  Real M = 0;
  for (const Point& p : w) M = std::max(M, length(p));
  const Real rounding = 4 * M * M * (100 * u * L) + 32 * u * M * M * M;
  return std::ranges::all_of(y.weight, [&](Real weight) { return weight > rounding; });
}

/// `A` and `B`: all points; `near_A`, `near_B`: those among which the closest are looked for.
Bounds bounds(const Points& A, const Points& B, const Points& near_A, const Points& near_B, Real L) {
  Bounds found;
  const std::vector<VertexPair> pairs = guess_nearest(near_A, near_B);
  std::vector<Point> w;
  for (const auto& [a, b] : pairs) {
    w.push_back(near_A[static_cast<std::size_t>(a)] - near_B[static_cast<std::size_t>(b)]);
  }
  const auto y = guess::nearest(std::span<const Point>(w));
  if (!y) return found;
  found.overlap = is_inside(w, *y, L);
  if (y->count == 4) return found;
  Point nearest = {0, 0, 0};
  for (int i = 0; i < y->count; ++i) {
    const auto member = static_cast<std::size_t>(i);
    nearest = nearest + Real(y->weight[member] / y->total) * w[static_cast<std::size_t>(y->members[member])];
  }
  found.hi = length(nearest) + error_of_bound * L;
  const Point n = direction(w, *y);
  Real least = std::numeric_limits<Real>::infinity();
  for (const Point& a : A) least = std::min(least, dot(n, a));
  Real greatest = -std::numeric_limits<Real>::infinity();
  for (const Point& b : B) greatest = std::max(greatest, dot(n, b));
  const Real lo = (least - greatest) / length(n) - error_of_bound * L;
  if (lo > 0) found.lo = lo;
  return found;
}

double rounded_up(Real x) {
  const auto nearest = static_cast<double>(x);
  return nearest < x ? std::nextafter(nearest, infinity) : nearest;
}
double rounded_down(Real x) { return -rounded_up(-x); }

/// The points of a feature, empty if there is no such feature.
Points points_of(const PosedBody& body, const Feature& feature) {
  Points points;
  if (feature.part < 0 || feature.part >= static_cast<int>(body.parts.size())) return points;
  const Points& all = body.parts[static_cast<std::size_t>(feature.part)].points;
  for (const int v : feature.vertices) {
    if (v < 0 || v >= static_cast<int>(all.size())) return {};
    points.push_back(all[static_cast<std::size_t>(v)]);
  }
  return points;
}

double off(const Point& p, const PosedBody& body, const Feature& feature, Real L) {
  const Points points = points_of(body, feature);
  if (points.empty()) return infinity;
  const Points alone = {p};
  const Real radius = body.parts[static_cast<std::size_t>(feature.part)].radius;
  return rounded_up(std::max(Real(0), bounds(alone, points, alone, points, L).hi - radius + 4 * u * L));
}

}  // namespace in_long_doubles

struct EnclosedPair::Posed {
  in_long_doubles::Point origin;  ///< of A, in W; all points are relative to it
  in_long_doubles::PosedBody A;
  in_long_doubles::PosedBody B;
  in_long_doubles::Real L = 0;
};

EnclosedPair::EnclosedPair(const Scene& scene) {
  using in_long_doubles::point;
  const Body& A = scene.bodies[0];
  const Body& B = scene.bodies[1];
  const in_long_doubles::Point origin = point(A.X_WB.p_WB);
  auto pair = std::make_unique<Posed>();
  pair->origin = origin;
  pair->A = in_long_doubles::posed(A, {0, 0, 0});
  pair->B = in_long_doubles::posed(B, point(B.X_WB.p_WB) - origin);
  pair->L = pair->A.reach + pair->B.reach;
  posed_ = std::move(pair);
}

EnclosedPair::~EnclosedPair() = default;

std::optional<EnclosedDistance> EnclosedPair::distance() const {
  using in_long_doubles::Real;
  if constexpr (!in_long_doubles::is_long) return std::nullopt;
  constexpr Real none = std::numeric_limits<Real>::infinity();
  Real lo = none;
  Real hi = none;
  for (const in_long_doubles::PosedPart& a : posed_->A.parts) {
    for (const in_long_doubles::PosedPart& b : posed_->B.parts) {
      const Real radii = a.radius + b.radius;
      const in_long_doubles::Bounds cores = in_long_doubles::bounds(a.points, b.points, a.points, b.points, posed_->L);
      const Real rounding = 4 * in_long_doubles::u * posed_->L;
      if (cores.overlap || cores.hi + rounding < radii) return EnclosedDistance{Verdict::overlapping, {0, 0}};
      if (!(cores.lo - radii - rounding > 0)) {
        lo = -1;
        continue;
      }
      lo = std::min(lo, cores.lo - radii - rounding);
      hi = std::min(hi, cores.hi - radii + rounding);
    }
  }
  if (!(lo > 0) || !(hi < none)) return std::nullopt;
  return EnclosedDistance{Verdict::separated, {in_long_doubles::rounded_down(lo), in_long_doubles::rounded_up(hi)}};
}

double EnclosedPair::features_apart(const Feature& a, const Feature& b) const {
  using namespace in_long_doubles;
  if constexpr (!is_long) return infinity;
  const Points A = points_of(posed_->A, a);
  const Points B = points_of(posed_->B, b);
  if (A.empty() || B.empty()) return infinity;
  const Real radii = posed_->A.parts[static_cast<std::size_t>(a.part)].radius +
                     posed_->B.parts[static_cast<std::size_t>(b.part)].radius;
  return rounded_up(std::max(Real(0), bounds(A, B, A, B, posed_->L).hi - radii + 4 * u * posed_->L));
}

double EnclosedPair::off_feature_A(const Vec3& p_W, const Feature& a) const {
  const in_long_doubles::Point p = in_long_doubles::point(p_W) - posed_->origin;
  return in_long_doubles::off(p, posed_->A, a, posed_->L + in_long_doubles::length(p));
}

double EnclosedPair::off_feature_B(const Vec3& p_W, const Feature& b) const {
  const in_long_doubles::Point p = in_long_doubles::point(p_W) - posed_->origin;
  return in_long_doubles::off(p, posed_->B, b, posed_->L + in_long_doubles::length(p));
}

}  // namespace touchstone::reference
