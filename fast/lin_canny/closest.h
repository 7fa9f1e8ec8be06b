// The closest points of two features.
#pragma once

#include "fast/lin_canny/placed.h"

namespace touchstone::fast::lin_canny {

/// Points a, b of the two features (closed: with their boundary), as near to each other as rounding tells, in the
/// pair's frame; `features` are then the least ones that hold them.
struct Closest {
  FeaturePair features;
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  double squared = 0;  ///< |b − a|²
  /// One is a face, and what is over it of the other lies in its plane or below, wholly or in part. Nothing is measured
  /// then.
  bool below = false;
};

Closest closest(const Placed& A, const Placed& B, const FeaturePair& features);

}  // namespace touchstone::fast::lin_canny
