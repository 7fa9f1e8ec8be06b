#include "fast/pixel/cut.h"

#include <algorithm>

namespace touchstone::fast::pixel {
namespace {

/// Keeps side·p[axis] ≥ side·limit.
void cut_one_side(const Loop& loop, int axis, double side, double limit, Loop& result) {
  result.clear();
  const auto height = [&](const Vec3& p) { return side * (p[axis] - limit); };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3& p = loop[i];
    const Vec3& q = loop[i + 1 < loop.size() ? i + 1 : 0];
    const bool p_in = height(p) >= 0;
    const bool q_in = height(q) >= 0;
    if (p_in) result.push_back(p);
    if (p_in == q_in) continue;
    const double t = std::clamp((limit - p[axis]) / (q[axis] - p[axis]), 0.0, 1.0);
    result.push_back(p + t * (q - p));
  }
}

}  // namespace

void cut(const Loop& loop, int axis, double lo, double hi, Loop& scratch, Loop& result) {
  cut_one_side(loop, axis, 1, lo, scratch);
  cut_one_side(scratch, axis, -1, hi, result);
}

}  // namespace touchstone::fast::pixel
