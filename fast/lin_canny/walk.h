// Lin & Canny's walk: from features to neighbouring features, always nearer.
#pragma once

#include <vector>

#include "fast/lin_canny/closest.h"

namespace touchstone::fast::lin_canny {

/// Closest features, as far as doubles see.
///
/// Two closest points of features are the closest points of the bodies if each is in the Voronoi region of the other's
/// feature (Lin & Canny 1991; Mirtich 1998, theorem 1). The regions' planes are asked with d = b − a:
///   a vertex   d points up an edge of it      → that edge, the steepest first;
///   an edge    d points into one of its faces → that face;
///   a face     has no higher neighbour.
/// The neighbour's closest points are computed, and the step is taken only if they are nearer *as computed*. So the
/// squared distances of the pairs visited decrease strictly; there are finitely many pairs, so the walk ends, whatever
/// the rounding. It may end too early, where rounding hides a way down: the bracket (bracket.h) tells, not the walk.
///
/// What lies below a face in its region is on the far side of the body, or in it: the face that sees the point from
/// farthest outside, of all faces, takes over; if there is none, the point is inside (`inside`). Two edges that see
/// each other through a body are a local minimum, the one that Lin and Canny's walk has on disjoint bodies: so the far
/// face takes over even if it is no nearer, but only once a walk. The walk is then two strict descents at most.
struct Walked {
  Closest closest;
  bool inside = false;            ///< a vertex of one body is inside the other, as far as doubles see
  bool has_started_anew = false;  ///< on the far side
};

/// `visited`, if given, gets all closest pairs the walk stood at, the first included.
Walked walk(const Placed& A, const Placed& B, const FeaturePair& start, std::vector<Closest>* visited = nullptr);

}  // namespace touchstone::fast::lin_canny
