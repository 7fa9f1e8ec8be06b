// What each of the three routes finds out about a pair of cores; distance.cpp makes the truth about bodies from it.
#pragma once

#include <utility>
#include <vector>

#include "model/answers.h"
#include "reference/exact_pose_impl.h"

namespace touchstone::reference {

/// num/den
struct HomogeneousPoint {
  IntegerVec num;
  Integer den = 1;
};

/// In the integer units of a PosedPair (exact_pose_impl.h).
struct CoreNearest {
  Verdict cores = Verdict::separated;
  IntegerVec normal;  ///< d* = normal · height / denominator; 0 exactly when d* = 0
  Integer height = 1;
  Integer denominator = 1;
  std::vector<int> face_A;  ///< F_A, ascending; empty if the cores overlap
  std::vector<int> face_B;
  HomogeneousPoint point;  ///< a*, or b* (a vertex if either is one: small numbers); the other is d* from it
  bool point_is_of_B = false;

  // The proof; left empty by the routes that are second opinions.
  std::vector<std::pair<int, int>> pairs;
  std::vector<Integer> weights;
  Integer total = 1;     ///< Σ weights; Σ weights·(a − b) / total = d*
  IntegerVec direction;  ///< cores touch: of the supporting plane
};

CoreNearest nearest_certified(PosedPair& pair);
CoreNearest nearest_by_brute_force(PosedPair& pair);
CoreNearest nearest_by_qp(PosedPair& pair);

Rational squared_distance(const PosedPair& pair, const CoreNearest& nearest);  ///< |d*|², m²

}  // namespace touchstone::reference
