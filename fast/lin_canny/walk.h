// Lin & Canny's walk: from features to neighbouring features that are ever closer.
#pragma once

#include <vector>

#include "fast/lin_canny/closest.h"

namespace touchstone::fast::lin_canny {

/// The closest features, as far as doubles can tell.
///
/// The closest points of two features are the closest points of the bodies if each is in the Voronoi region of the
/// other's feature (Lin & Canny 1991; Mirtich 1998, theorem 1). The regions' planes are tested with d = b − a:
///   a vertex   d points up an edge of it      → that edge, the steepest first;
///   an edge    d points into one of its faces → that face;
///   a face     has no neighbour of higher dimension.
/// The neighbour's closest points are computed, and the step is taken only if they are closer *as computed*. So the
/// squared distances of the visited pairs decrease strictly; there are finitely many pairs, so the walk ends, whatever
/// the rounding. It may end too early, where rounding hides a descent: the bracket (bracket.h) detects this, not the
/// walk.
///
/// A point below a face, in the face's region, is inside the body or on its far side: the walk goes on from the face
/// whose plane the point is farthest outside of; if there is none, the point is inside (`inside`). Two edges that face
/// each other through a body are a local minimum, the one that Lin and Canny's walk has on disjoint bodies. So that
/// face is taken even if it is no closer, but only once per walk. The walk then consists of at most two strict
/// descents.
///
/// After some steps it goes on from facing_features(), if these are closer: so a start that is far away costs no more
/// than some steps.
struct Walked {
  Closest closest;
  bool inside = false;         ///< a vertex of one body is inside the other, as far as doubles see
  bool has_restarted = false;  ///< continued once from a far face that was no closer
};

/// `visited`, if given, receives all closest pairs that the walk visited, including the first.
Walked walk(const PosedHull& A, const PosedHull& B, const FeaturePair& start, std::vector<Closest>* visited = nullptr);

/// The edge at vertex v that rises most steeply along d (in the hull's frame), as doubles say; -1 if none does.
int steepest_edge(const Hull& hull, int v, const Vec3& d);

/// Where to start without a memory. A step of Gilbert, Johnson & Keerthi's descent: the vertices that face each other
/// along the line of the two origins, those that do along the line of these, and the point of the segment between the
/// two differences that is nearest to 0. It lies in a vertex or an edge of each, or else in no feature, and then the
/// nearer two vertices do. It only saves steps of the walk, which cost more; the walk may start anywhere, so nothing
/// has to hold of the two features.
FeaturePair facing_features(const PosedHull& A, const PosedHull& B);

}  // namespace touchstone::fast::lin_canny
