// A body's shape prepared for queries about pairs.
#pragma once

#include <vector>

#include "fast/lin_canny/hull.h"
#include "fast/lin_canny/posed_hull.h"

namespace touchstone::fast::lin_canny {

/// All points within `radius` of a core: a point for a sphere, otherwise the polytope itself (radius 0).
struct Convex {
  Hull core;
  double radius = 0;
  double reach = 0;       ///< ≥ |p| for its points p relative to the body's origin
  bool is_posed = false;  ///< a part of a compound; otherwise X_BP is the identity
  Pose X_BP;              ///< its pose in the body
  Mat3 R_BP;              ///< computed from X_BP
};

class Solid {
 public:
  /// What the cores have: vertices, edges and faces; or vertices alone (Hull::of_vertices).
  enum class Preparation : unsigned char { whole, vertices };

  /// Requires a valid shape. Throws InputError if it prepares a whole polytope whose faces are missing or are not the
  /// boundary of a convex solid.
  explicit Solid(const Shape& shape, Preparation preparation = Preparation::whole);

  const std::vector<Convex>& parts() const { return parts_; }

 private:
  std::vector<Convex> parts_;
};

/// A pose of a body with its rotation matrix, computed once for all of its pairs.
struct CachedPose {
  explicit CachedPose(const Pose& X) : X_WB(X), R_WB(rotation(X.q_WB)) {}

  Pose X_WB;
  Mat3 R_WB;
};

/// The part's core with the axes of W, relative to `p_WO`.
PosedHull posed_hull(const Convex& part, const CachedPose& body, const Vec3& p_WO);

}  // namespace touchstone::fast::lin_canny
