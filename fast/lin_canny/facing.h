// Vertices of a hull that are high along a direction.
#pragma once

#include "fast/lin_canny/hull.h"

namespace touchstone::fast::lin_canny {

/// The first vertex of greatest d·v as computed. Looks at all of them.
int highest(const Hull& hull, const Vec3& d);

/// max d·v over all vertices v, as computed.
inline double greatest_height(const Hull& hull, const Vec3& d) { return d.dot(hull.vertex(highest(hull, d))); }

/// From a vertex along the steepest edges, as floats can tell, to one that no edge leaves upwards. Requires edges and
/// max |d_i| = 1. What counts as rising rises in exact numbers too, so it ends.
int climbed(const Hull& hull, int from, const Vec3& d);

/// A vertex that is about the highest along d. Few vertices are compared one by one. Of many, a climb begins at the one
/// that the hull's table gives for directions like d. Any vertex, if d is 0 or not finite. Requires edges.
int facing(const Hull& hull, const Vec3& d);

}  // namespace touchstone::fast::lin_canny
