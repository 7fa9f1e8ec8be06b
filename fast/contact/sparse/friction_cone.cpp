#include "fast/contact/sparse/friction_cone.h"

namespace touchstone::fast::contact {
namespace {

/// Of a vector: its part along n, its part across n, and the latter's length and direction.
struct Split {
  Split(const Vec3& z, const Vec3& n) : along(n.dot(z)), across(z - along * n), slip(across.norm()) {
    if (slip > 0) d = across / slip;
  }
  double along;
  Vec3 across;
  double slip;
  Vec3 d = Vec3::Zero();
};

/// The projection on the plane across n and d.
Mat3 sideways(const Vec3& n, const Vec3& d) { return Mat3::Identity() - n * n.transpose() - d * d.transpose(); }

}  // namespace

ConeImpulse nearest_in_cone(const Vec3& z, const Vec3& n, double friction) {
  const Split of(z, n);
  if (of.along > 0 && of.slip <= friction * of.along) return {z, Mat3::Identity()};
  if (friction * of.slip <= -of.along || of.slip == 0) return {};
  const Vec3 edge = n + friction * of.d;
  const double P_n = (of.along + friction * of.slip) / (1 + friction * friction);
  return {P_n * edge,
          edge * edge.transpose() / (1 + friction * friction) + friction * P_n / of.slip * sideways(n, of.d)};
}

ConeImpulse nearest_in_disc(const Vec3& z, const Vec3& n, double friction) {
  const Split of(z, n);
  if (!(of.along > 0)) return {};
  const double most = friction * of.along;
  if (of.slip <= most) return {z, Mat3::Identity()};
  const Vec3 edge = n + friction * of.d;
  return {of.along * edge, edge * n.transpose() + most / of.slip * sideways(n, of.d)};
}

}  // namespace touchstone::fast::contact
