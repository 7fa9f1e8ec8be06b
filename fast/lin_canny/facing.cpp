#include "fast/lin_canny/facing.h"

#include <algorithm>
#include <cstddef>

namespace touchstone::fast::lin_canny {

int highest(const Hull& hull, const Vec3& d) {
  int best = 0;
  double most = d.dot(hull.vertex(0));
  for (int v = 1; v < hull.vertex_count(); ++v) {
    const double height = d.dot(hull.vertex(v));
    best = height > most ? v : best;
    most = std::max(most, height);
  }
  return best;
}

int climbed(const Hull& hull, int from, const Vec3& d) {
  const FloatDirection direction(d);
  int at = from;
  while (true) {
    float most = direction.error();
    int next = at;
    for (const Hull::Spokes& some : hull.spokes(at)) {
      const FloatDirection::Slopes slopes = direction.slopes(some);
      for (std::size_t lane = 0; lane < Hull::Spokes::lanes; ++lane) {
        next = slopes[lane] > most ? some.other[lane] : next;
        most = std::max(most, slopes[lane]);
      }
    }
    if (next == at) return at;
    at = next;
  }
}

int facing(const Hull& hull, const Vec3& d) {
  const double size = d.lpNorm<Eigen::Infinity>();
  if (!(size > 0) || !d.allFinite()) return 0;
  const Vec3 scaled = d / size;
  const int near = hull.by_direction(scaled);
  return near < 0 ? highest(hull, d) : climbed(hull, near, scaled);
}

}  // namespace touchstone::fast::lin_canny
