// Clips a convex polygon by half-spaces, in the plane or in space.
#pragma once

#include <cstddef>
#include <vector>

namespace touchstone::fast::contact {

/// The part of a convex polygon at which `height(p)` ≥ 0, in order around it; `height` is affine. One step of
/// Sutherland & Hodgman 1974. A point counts as a polygon of one corner, and a segment as one of two corners, there and
/// back. So where a segment crosses height 0, the crossing is returned twice: computed from each end, once from the
/// last corner to the first.
template <class Point, class Height>
std::vector<Point> clip_polygon(const std::vector<Point>& polygon, const Height& height) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = height(p), at_q = height(q);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

}  // namespace touchstone::fast::contact
