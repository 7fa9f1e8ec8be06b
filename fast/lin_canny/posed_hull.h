// A hull in the pair's frame: W's axes, with the origin at body A.
#pragma once

#include "fast/lin_canny/hull.h"
#include "fast/lin_canny/rotation.h"

namespace touchstone::fast::lin_canny {

enum class Kind : unsigned char { vertex, edge, face };

struct FeatureId {
  Kind kind = Kind::vertex;
  int index = 0;

  bool operator==(const FeatureId&) const = default;
};

struct FeaturePair {
  FeatureId a;
  FeatureId b;

  bool operator==(const FeaturePair&) const = default;
};

/// x ↦ R x + t in doubles. For a vertex x |computed R x − exact| ≤ turn_error |x|; the error of t is at most
/// shift_error.
struct PosedHull {
  const Hull* hull = nullptr;
  Mat3 R = Mat3::Identity();
  Vec3 t = Vec3::Zero();
  double turn_error = lin_canny::turn_error;
  double shift_error = 0;

  Vec3 out(const Vec3& x) const { return R * x + t; }
  Vec3 in(const Vec3& p) const { return R.transpose() * (p - t); }
  Vec3 turned_out(const Vec3& v) const { return R * v; }
  Vec3 turned_in(const Vec3& v) const { return R.transpose() * v; }
  Vec3 vertex(int v) const { return out(hull->vertex(v)); }
};

/// Whether products of four lengths of the pair neither overflow nor lose bits to underflow.
inline bool fit_doubles(const PosedHull& A, const PosedHull& B) {
  return A.hull->fits_doubles() && B.hull->fits_doubles() && (B.t - A.t).lpNorm<Eigen::Infinity>() < 0x1p250;
}

}  // namespace touchstone::fast::lin_canny
