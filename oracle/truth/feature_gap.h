// The gap between the claimed features. A pair of features is right if it is as near as the bodies are.
#pragma once

#include <optional>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::oracle {

/// min |x − y| over x in the hull of A's claimed vertices and y in that of B's, in W, m. None if a feature names a part
/// or a vertex that does not exist, or has no vertex. (A sphere's only vertex is its centre, so the gap is one between
/// cores.)
///
/// Computed as the least over all vertex-triangle and edge-edge pairs of the claimed vertices: right for points,
/// segments and plane polygons, in whichever order their vertices are listed. In long double (u = 2⁻⁶⁴ on x86): the
/// error is far below a subject's own allowance, whatever the angle of two edges. Every candidate is a distance of two
/// points of the hulls, so the gap is never too small by more than that.
std::optional<double> feature_gap(const Body& A, const Feature& feature_A, const Body& B, const Feature& feature_B);

/// How far the claimed vertices are from being those of one face of their part (m): the greatest distance of one of
/// them from the plane through three of them, or of another vertex of the part beyond that plane; of all such planes
/// that of the widest triangle. No more than about that triangle's height, for vertices that are nearly on one line; 0
/// if they are fewer than three. Without rounding, unless it is as good as 0. Requires vertices that exist.
double off_one_face(const Body& body, const Feature& feature);

}  // namespace touchstone::oracle
