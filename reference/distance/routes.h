// The result of each of the three routes for a pair of cores. reference/distance.cpp turns it into the truth about
// bodies.
#pragma once

#include <utility>
#include <vector>

#include "model/answers.h"
#include "reference/exact/exact_pose.h"

namespace touchstone::reference {

/// num/den
struct HomogeneousPoint {
  IntegerVec num;
  Integer den = 1;
};

/// In the integer units of a PosedPair (reference/exact/exact_pose.h).
struct CoreNearest {
  Verdict cores = Verdict::separated;
  IntegerVec normal;  ///< d* = normal · height / denominator; 0 exactly if d* = 0
  Integer height = 1;
  Integer denominator = 1;
  std::vector<int> face_A;  ///< F_A, ascending; empty if the cores overlap
  std::vector<int> face_B;
  HomogeneousPoint point;  ///< a*, or b* (a vertex if either is one: small numbers); d* gives the other
  bool point_is_of_B = false;

  // The proof. The second routes leave it empty.
  std::vector<std::pair<int, int>> pairs;
  std::vector<Integer> weights;
  Integer total = 1;     ///< Σ weights; Σ weights·(a − b) / total = d*
  IntegerVec direction;  ///< touching cores: normal of the supporting plane
};

CoreNearest nearest_certified(PosedPair& pair);
CoreNearest nearest_by_brute_force(PosedPair& pair);
CoreNearest nearest_by_qp(PosedPair& pair);

Rational squared_distance(const PosedPair& pair, const CoreNearest& nearest);  ///< |d*|², m²

}  // namespace touchstone::reference
