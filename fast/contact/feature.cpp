#include "fast/contact/feature.h"

#include <Eigen/Geometry>
#include <cmath>

namespace touchstone::fast::contact {
namespace {

using Kind = Feature::Kind;

/// The point of the line p + s d that is nearest to the line q + t e; `across` is d × e. By cross products, whose error
/// grows with the inverse of the sine of the angle, where that of 1 − (d·e)² grows with its square.
Vec3 nearest_on_line(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e, const Vec3& across) {
  return p + (q - p).cross(e).dot(across) / across.squaredNorm() * d;
}

Nearness point_and_plane(const Vec3& p, double radius, const Vec3& on, const Vec3& n) {
  return {n.dot(p - on) - radius, n, p - radius * n};
}

/// The gap is that of the nearest points, which are close to each other: n may be off by the rounding of d over the
/// sine of the angle.
Nearness two_lines(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e, const Vec3& about) {
  const Vec3 across = d.cross(e);
  Vec3 n = across.normalized();
  if (n.dot(about) < 0) n = -n;
  const Vec3 on_p = nearest_on_line(p, d, q, e, across), on_q = nearest_on_line(q, e, p, d, -across);
  return {n.dot(on_p - on_q), n, on_p};
}

/// `p` and `q`: centres of balls, or the points of lines nearest to them.
Nearness two_points(const Vec3& p, double radius_p, const Vec3& q, double radius_q, const Vec3& about) {
  const Vec3 apart = p - q;
  const double far = apart.norm();
  const Vec3 n = far > 0 ? Vec3(apart / far) : about;
  return {far - radius_p - radius_q, n, p - radius_p * n};
}

}  // namespace

Nearness nearness(const Feature& a, const RigidTransform& A, const Feature& b, const RigidTransform& B,
                  const Vec3& about) {
  const Vec3 p = A.out(a.at), q = B.out(b.at), d = A.R_WB * a.along, e = B.R_WB * b.along;
  if (b.kind == Kind::plane) return point_and_plane(p, a.radius, q, e);
  if (a.kind == Kind::plane) {
    const double gap = d.dot(q - p) - b.radius;
    return {gap, -d, q - (b.radius + gap) * d};
  }
  if (a.kind == Kind::line && b.kind == Kind::line) return two_lines(p, d, q, e, about);
  const Vec3 on_a = a.kind == Kind::line ? Vec3(p + d.dot(q - p) * d) : p;
  const Vec3 on_b = b.kind == Kind::line ? Vec3(q + e.dot(p - q) * e) : q;
  return two_points(on_a, a.radius, on_b, b.radius, about);
}

}  // namespace touchstone::fast::contact
