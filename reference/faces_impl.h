// Faces and edges of a posed core, with exact normals behind enclosed ones.
#pragma once

#include <vector>

#include "reference/exact_pose_impl.h"

namespace touchstone::reference {

/// An edge with the faces on its left and right, seen from outside, going from tail to head.
struct Edge {
  int tail, head;
  int left, right;
};

/// The edges of a closed surface, each once, in the order of their (smaller, greater) vertex.
std::vector<Edge> edges_of(const std::vector<std::vector<int>>& faces);

/// Outward, exact; some positive multiple of the unit normal.
IntegerVec exact_normal(const PosedCore& core, int face);

/// Around some positive multiple of the unit normal. Inside RoundUpward, after enclose().
EnclosureVec enclosed_normal(const PosedCore& core, int face);

}  // namespace touchstone::reference
