// The independent checker. It shares no code with the routes, not even the exact pose: plain rationals and the formulas
// of model/frame.h and reference/certificate.h. Its correctness can be checked by reading this file.
#include <gmpxx.h>

#include <array>
#include <optional>

#include "reference/certificate.h"
#include "reference/exact/rational.h"

namespace touchstone::reference {
namespace {

using Vec = std::array<mpq_class, 3>;

mpq_class dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec rational(const Vec3& v) { return {mpq_class(v.x()), mpq_class(v.y()), mpq_class(v.z())}; }
Vec rational(const RationalVec3& v) { return {v.x.impl().value, v.y.impl().value, v.z.impl().value}; }

Vec transform(const Pose& X, const Vec& v) {
  const mpq_class w(X.q_WB.w), x(X.q_WB.x), y(X.q_WB.y), z(X.q_WB.z);
  const mpq_class squared = w * w + x * x + y * y + z * z;
  const Vec row_x = {w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)};
  const Vec row_y = {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)};
  const Vec row_z = {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z};
  const Vec t = rational(X.p_WB);
  return {dot(row_x, v) / squared + t[0], dot(row_y, v) / squared + t[1], dot(row_z, v) / squared + t[2]};
}

std::vector<Vec3> vertices_of(const ConvexShape& shape) {
  if (const auto* polytope = std::get_if<Polytope>(&shape)) return polytope->vertices;
  if (std::holds_alternative<Sphere>(shape)) return {Vec3::Zero()};
  const Vec3& h = std::get<Box>(shape).half_extents;
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back((i & 1) ? h.x() : -h.x(), (i & 2) ? h.y() : -h.y(), (i & 4) ? h.z() : -h.z());
  return corners;
}

/// The vertices of a convex part in W; empty if the body has no such part.
std::vector<Vec> in_world(const Body& body, int part) {
  std::vector<Vec> points;
  if (const auto* compound = std::get_if<Compound>(&body.shape)) {
    if (part < 0 || part >= static_cast<int>(compound->parts.size())) return points;
    const Part& p = compound->parts[static_cast<std::size_t>(part)];
    for (const Vec3& v : vertices_of(p.shape)) points.push_back(transform(body.X_WB, transform(p.X_BP, rational(v))));
    return points;
  }
  if (part != 0) return points;
  ConvexShape shape;
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) shape = *sphere;
  if (const auto* box = std::get_if<Box>(&body.shape)) shape = *box;
  if (const auto* polytope = std::get_if<Polytope>(&body.shape)) shape = *polytope;
  for (const Vec3& v : vertices_of(shape)) points.push_back(transform(body.X_WB, rational(v)));
  return points;
}

/// min n·a − max n·b, the least value of n·(a − b).
mpq_class least_height(const Vec& n, const std::vector<Vec>& A, const std::vector<Vec>& B) {
  mpq_class low = dot(n, A[0]);
  for (const Vec& a : A) low = std::min(low, mpq_class(dot(n, a)));
  mpq_class high = dot(n, B[0]);
  for (const Vec& b : B) high = std::max(high, mpq_class(dot(n, b)));
  return low - high;
}

mpq_class determinant(const Vec& a, const Vec& b, const Vec& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

bool span_space(const std::vector<Vec>& w) {
  for (std::size_t i = 0; i < w.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        if (determinant(w[i], w[j], w[k]) != 0) return true;
      }
    }
  }
  return false;
}

Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The square of the distance of 0 from the plane through three of the points, if no point is beyond the plane.
std::optional<mpq_class> squared_height(const std::vector<Vec>& points, const Vec& a, const Vec& b, const Vec& c) {
  const Vec n = cross(minus(b, a), minus(c, a));
  const mpq_class square = dot(n, n);
  if (square == 0) return std::nullopt;
  bool is_above = false, is_below = false;
  for (const Vec& p : points) {
    const int side = sgn(dot(n, minus(p, a)));
    is_above = is_above || side > 0;
    is_below = is_below || side < 0;
  }
  if (is_above && is_below) return std::nullopt;
  const mpq_class height = dot(n, a);
  return mpq_class(height * height / square);
}

}  // namespace

double inner_radius(const Certificate& c, const Scene& scene) {
  const std::vector<Vec> A = in_world(scene.bodies[0], c.part_A), B = in_world(scene.bodies[1], c.part_B);
  std::vector<Vec> corners;
  for (const auto& [a, b] : c.pairs)
    corners.push_back(minus(A.at(static_cast<std::size_t>(a)), B.at(static_cast<std::size_t>(b))));
  std::optional<mpq_class> least;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const std::optional<mpq_class> height = squared_height(corners, corners[i], corners[j], corners[k]);
        if (height && (!least || *height < *least)) least = height;
      }
    }
  }
  return least ? rational_of(*least).sqrt_enclosure().lo : 0;
}

std::string check(const Certificate& c, const Scene& scene) {
  if (scene.bodies.size() < 2) return "the scene has no two bodies";
  const std::vector<Vec> A = in_world(scene.bodies[0], c.part_A);
  const std::vector<Vec> B = in_world(scene.bodies[1], c.part_B);
  if (A.empty() || B.empty()) return "it names a part that is not there";
  if (c.pairs.empty() || c.pairs.size() != c.weights.size()) return "it has no pairs, or not one weight a pair";

  std::vector<Vec> differences;
  Vec sum = {0, 0, 0};
  mpq_class total = 0;
  for (std::size_t i = 0; i < c.pairs.size(); ++i) {
    const auto& [a, b] = c.pairs[i];
    if (a < 0 || a >= static_cast<int>(A.size()) || b < 0 || b >= static_cast<int>(B.size())) {
      return "it names a vertex that is not there";
    }
    const mpq_class& weight = c.weights[i].impl().value;
    if (weight < 0) return "a weight is negative";
    differences.push_back(minus(A[static_cast<std::size_t>(a)], B[static_cast<std::size_t>(b)]));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * differences.back()[k];
    total += weight;
  }
  if (total != 1) return "the weights do not add up to 1";

  const Vec zero = {0, 0, 0};
  const Vec n = rational(c.direction);
  if (c.cores == Verdict::separated) {
    if (n == zero) return "the direction is 0";
    if (sum != n) return "the direction is not the weighted sum of its pairs";
    if (least_height(n, A, B) < dot(n, n)) return "a vertex pair is nearer than the direction says";
    return "";
  }
  if (sum != zero) return "the weighted sum of its pairs is not 0, so they show no common point";
  if (c.cores == Verdict::touching) {
    if (n == zero) return "the direction is 0";
    if (least_height(n, A, B) < 0) return "the plane does not keep the bodies apart";
    return "";
  }
  if (n != zero) return "an overlap has no direction";
  for (const Rational& weight : c.weights) {
    if (weight.sign() == 0) return "a weight is 0, so 0 may lie on the boundary";
  }
  if (!span_space(differences)) return "the pairs lie in a plane, so the common point may be on the boundary";
  return "";
}

}  // namespace touchstone::reference
