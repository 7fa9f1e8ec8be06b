// Faces and edges of a posed core, with exact normals and enclosures of them.
#pragma once

#include <vector>

#include "reference/exact/exact_pose.h"

namespace touchstone::reference {

/// An edge from tail to head, with the faces on its left and right as seen from outside.
struct Edge {
  int tail, head;
  int left, right;
};

/// The edges of a closed surface, each once, ordered by (smaller, greater) vertex.
std::vector<Edge> edges_of(const std::vector<std::vector<int>>& faces);

/// An exact outward normal: some positive multiple of the unit normal.
IntegerVec exact_normal(const PosedCore& core, int face);

/// An enclosure of some positive multiple of the unit normal. Call inside RoundUpward, after enclose().
EnclosureVec enclosed_normal(const PosedCore& core, int face);

}  // namespace touchstone::reference
