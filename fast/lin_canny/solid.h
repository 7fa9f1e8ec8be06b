// A body's shape made ready for questions about pairs.
#pragma once

#include <vector>

#include "fast/lin_canny/hull.h"
#include "fast/lin_canny/placed.h"

namespace touchstone::fast::lin_canny {

/// All points within `radius` of a core: a point for a sphere, the polytope itself (radius 0) else.
struct Convex {
  Hull core;
  double radius = 0;
  Pose X_BP;              ///< where it stands in the body
  Mat3 R_BP;              ///< computed from X_BP
  bool is_posed = false;  ///< a part of a compound; else X_BP is not there
  double reach = 0;       ///< ≥ |p| for its points p as seen from the body's origin
};

class Solid {
 public:
  /// Requires a valid shape; throws InputError where a polytope's faces are missing or not the boundary of a convex
  /// solid.
  explicit Solid(const Shape& shape);

  const std::vector<Convex>& parts() const { return parts_; }

 private:
  std::vector<Convex> parts_;
};

/// A pose of a body with its rotation, computed once for all of its pairs.
struct Station {
  explicit Station(const Pose& X) : X_WB(X), R_WB(rotation(X.q_WB)) {}

  Pose X_WB;
  Mat3 R_WB;
};

/// The part's core with the axes of W, seen from `p_WO`.
Placed placed(const Convex& part, const Station& body, const Vec3& p_WO);

}  // namespace touchstone::fast::lin_canny
