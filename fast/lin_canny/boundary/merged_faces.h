// The maximal faces of a polytope whose given faces may have coplanar neighbours.
#pragma once

#include <vector>

#include "fast/lin_canny/boundary/half_edges.h"
#include "model/shape.h"

namespace touchstone::fast::lin_canny {

struct MergedFaces {
  std::vector<int> vertices;  ///< the corners, as indices of the polytope's vertices; ascending
  Loops loops;                ///< of each face, as indices of `vertices`; counter-clockwise seen from outside
  HalfEdges edges;            ///< of these loops
};

/// A loop starts at its least corner, and has no straight corners. Coplanar and collinear are decided exactly. Throws
/// InputError if an edge does not occur once in each direction, or if the faces do not bound a convex solid.
MergedFaces merged_faces(const Polytope& polytope);

}  // namespace touchstone::fast::lin_canny
