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

  Vec3 out(const Vec3& x) const { return turned_out(x) + t; }
  Vec3 in(const Vec3& p) const { return turned_in(p - t); }
  Vec3 turned_out(const Vec3& v) const {
    return {R(0, 0) * v.x() + (R(0, 1) * v.y() + R(0, 2) * v.z()),
            R(1, 0) * v.x() + (R(1, 1) * v.y() + R(1, 2) * v.z()),
            R(2, 0) * v.x() + (R(2, 1) * v.y() + R(2, 2) * v.z())};
  }
  Vec3 turned_in(const Vec3& v) const {
    return {R(0, 0) * v.x() + (R(1, 0) * v.y() + R(2, 0) * v.z()),
            R(0, 1) * v.x() + (R(1, 1) * v.y() + R(2, 1) * v.z()),
            R(0, 2) * v.x() + (R(1, 2) * v.y() + R(2, 2) * v.z())};
  }
  Vec3 vertex(int v) const { return out(hull->vertex(v)); }
  /// From tail to head.
  Vec3 edge_vector(int e) const { return turned_out(hull->along(hull->edge(e))); }
};

/// Whether products of four lengths of the pair neither overflow nor lose bits to underflow.
inline bool fit_doubles(const PosedHull& A, const PosedHull& B) {
  return A.hull->fits_doubles() && B.hull->fits_doubles() && (B.t - A.t).lpNorm<Eigen::Infinity>() < 0x1p250;
}

}  // namespace touchstone::fast::lin_canny
