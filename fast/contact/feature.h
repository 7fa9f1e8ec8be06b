// A feature of a body's boundary at which another body touches it: a point, the line of an edge or the plane of a face.
#pragma once

#include "fast/lin_canny/solid.h"

namespace touchstone::fast::contact {

/// All points within `radius` of a point, a line or a plane that is fixed in the body. Given in the body's axes,
/// relative to its centre of mass (of a fixed body: its origin).
struct Feature {
  enum class Kind { point, line, plane };
  Kind kind = Kind::point;
  Vec3 at = Vec3::Zero();     ///< a point of the feature
  Vec3 along = Vec3::Zero();  ///< unit: a line's direction, or a plane's outward normal
  double radius = 0;          ///< m; of a point
};

/// Pose of a body, with its centre of mass (of a fixed body: its origin) in place of the origin.
struct RigidTransform {
  Vec3 centre = Vec3::Zero();
  Mat3 R_WB = Mat3::Identity();

  Vec3 out(const Vec3& p_B) const { return centre + R_WB * p_B; }
  Vec3 in(const Vec3& p_W) const { return R_WB.transpose() * (p_W - centre); }
};

struct Nearness {
  double gap = 0;                 ///< m, along n̂; < 0: overlap
  Vec3 nhat_BA_W = Vec3::Zero();  ///< unit, from B to A
  Vec3 p_WC = Vec3::Zero();       ///< on A
};

/// Gap, normal and contact point of two features. If one is a plane, its normal is the pair's. Otherwise n̂ is the
/// direction of the shortest connection of the two, with the sign that makes n̂·about ≥ 0 for two lines, or `about`
/// itself where there is no such connection. Does not support a plane with a line or a plane, nor parallel lines.
Nearness nearness(const Feature& a, const RigidTransform& A, const Feature& b, const RigidTransform& B,
                  const Vec3& about);

}  // namespace touchstone::fast::contact
