#include "fast/simulation/prediction/spin.h"

#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/sine.h"
#include "fast/simulation/prediction/length.h"

namespace touchstone::fast::simulation {

Quaternion turned(const Quaternion& start, const Vec3& angle) {
  const Quaternion q = lin_canny::at_moderate_scale(start);
  const double size = length(angle);
  if (!(size > 0 && size < 0x1p50)) return q;
  const auto [sine, c] = motion::sine_cosine(size / 2);
  const Vec3 s = sine / size * angle;
  const double w = c * q.w - (s.x() * q.x + s.y() * q.y + s.z() * q.z);
  const double x = c * q.x + s.x() * q.w + (s.y() * q.z - s.z() * q.y);
  const double y = c * q.y + s.y() * q.w + (s.z() * q.x - s.x() * q.z);
  const double z = c * q.z + s.z() * q.w + (s.x() * q.y - s.y() * q.x);
  const double shrink = 1 / std::sqrt((w * w + x * x) + (y * y + z * z));
  return {w * shrink, x * shrink, y * shrink, z * shrink};
}

}  // namespace touchstone::fast::simulation
