// The closest points of two hulls from their vertices alone.
#pragma once

#include <vector>

#include "fast/lin_canny/bracket.h"
#include "fast/lin_canny/simplex.h"

namespace touchstone::fast::lin_canny {

/// Gilbert, Johnson & Keerthi's descent over B − A, in doubles.
///
/// It starts along the line of the two origins, and ends when no vertex difference is lower than the simplex by more
/// than an eighth of the rounding error, when doubles find no subset, or after `most_vertices` steps. Where it ends
/// proves nothing: bracket() and common_point() do. Four points: they surround 0, as far as doubles can tell.
Simplex descend(const PosedHull& A, const PosedHull& B, double rounding_error);

/// As bracket() of two features (bracket.h), for a simplex of at most three differences. The witnesses are convex
/// combinations of at most three vertices each, so hi has the error of points of faces. lo is the gap between two
/// planes perpendicular to the features, each at its highest vertex of all. So a descent that ended early, or lengths
/// that underflow, only give a wide enclosure. Features that are shorter than the rounding error, those of a speck
/// beside a giant, say nothing about the direction: where the enclosure is wider than rounding explains, the
/// directions of fewer features are tried too.
Bracket bracket(const PosedHull& A, const PosedHull& B, const Simplex& nearest, double rounding_error);

/// The vertices of a hull that are highest along n (of length 1, in the pair's frame), as far as rounding can tell: a
/// vertex, the ends of an edge, or the corners of a face. And those of the simplex (`side`: A's or B's), whose hull has
/// the witness: where edges are almost parallel, n has an error that lifts another vertex above them.
std::vector<int> closest_vertices(const PosedHull& P, const Vec3& n, const Simplex& nearest,
                                  int VertexDifference::*side);

}  // namespace touchstone::fast::lin_canny
