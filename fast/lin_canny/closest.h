// The closest points of two features.
#pragma once

#include "fast/lin_canny/posed_hull.h"

namespace touchstone::fast::lin_canny {

/// Points a, b of the two features (closed: with their boundary), as close to each other as rounding permits, in the
/// pair's frame; `features` are then the lowest-dimensional features that contain them.
struct Closest {
  FeaturePair features;
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  double squared = 0;  ///< |b − a|²
  /// One feature is a face, and the part of the other that is over it lies in its plane or below, wholly or in part. No
  /// distance is then measured.
  bool below = false;
};

Closest closest(const PosedHull& A, const PosedHull& B, const FeaturePair& features);

}  // namespace touchstone::fast::lin_canny
