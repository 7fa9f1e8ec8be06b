// What each of the three routes finds out about a pair of cores; distance.cpp makes the truth about bodies from it.
#pragma once

#include <utility>
#include <vector>

#include "model/answers.h"
#include "reference/exact_pose_impl.h"

namespace touchstone::reference {

/// In the integer units of a PosedPair (exact_pose_impl.h).
struct CoreNearest {
  Verdict cores = Verdict::separated;
  IntegerVec difference;  ///< d* = difference / denominator
  Integer denominator = 1;
  std::vector<int> face_A;  ///< F_A, ascending; empty if the cores overlap
  std::vector<int> face_B;
  IntegerVec point_A;  ///< a* = point_A / point_denominator
  Integer point_denominator = 1;

  // The proof; left empty by the routes that are second opinions.
  std::vector<std::pair<int, int>> pairs;
  std::vector<Integer> weights;  ///< Σ weights = denominator, Σ weights·(a − b) = difference
  IntegerVec direction;          ///< cores touch: of the supporting plane
};

CoreNearest nearest_certified(PosedPair& pair);
CoreNearest nearest_by_brute_force(PosedPair& pair);
CoreNearest nearest_by_qp(PosedPair& pair);

}  // namespace touchstone::reference
