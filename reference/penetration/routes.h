// The depth of two cores with a common point, by two routes. reference/penetration.cpp makes the truth from it.
#pragma once

#include "reference/exact/exact_pose.h"

namespace touchstone::reference {

/// The facet of A − B whose plane n·x = gap is nearest to 0: depth = gap/|n|, in the integer units of the pair. n
/// points outward.
struct CoreDepth {
  IntegerVec normal;
  Integer gap;
};

/// Both require that 0 is in A − B, and that A or B has volume.
CoreDepth depth_by_gauss_map(PosedPair& pair);
CoreDepth depth_by_minkowski_hull(PosedPair& pair);

/// Keeps the shallowest facet; the first one of equals.
class Shallowest {
 public:
  void offer(IntegerVec normal, Integer gap);
  CoreDepth take() { return std::move(best_); }

 private:
  CoreDepth best_;  ///< normal 0: no facet so far
  Integer gap_squared_;
  Integer length_squared_;
};

}  // namespace touchstone::reference
