// A point, an edge's line or a face's plane of a body: what of its boundary another body touches.
#pragma once

#include "fast/lin_canny/solid.h"

namespace touchstone::fast::contact {

/// All points within `radius` of a point, a line or a plane that is fixed in the body. Seen from the body's centre (of
/// mass; of a fixed body its origin), in its axes.
struct Feature {
  enum class Kind { point, line, plane };
  Kind kind = Kind::point;
  Vec3 at = Vec3::Zero();     ///< on it
  Vec3 along = Vec3::Zero();  ///< unit: a line's direction, a plane's outward normal
  double radius = 0;          ///< of a point
};

/// Where a body stands.
struct Stance {
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

/// How near two features are. A plane's normal is the pair's; else n̂ is that of the shortest way between the two,
/// turned to the side of `about`, or `about` itself where there is no such way. Not of a plane with a line or a plane,
/// nor of parallel lines.
Nearness nearness(const Feature& a, const Stance& A, const Feature& b, const Stance& B, const Vec3& about);

}  // namespace touchstone::fast::contact
