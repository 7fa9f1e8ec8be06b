#include "fast/motion/quaternion.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::motion {

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {(a.w * b.w - a.x * b.x) - (a.y * b.y + a.z * b.z), (a.w * b.x + a.x * b.w) + (a.y * b.z - a.z * b.y),
          (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z), (a.w * b.z + a.z * b.w) + (a.x * b.y - a.y * b.x)};
}

Quaternion unit(const Quaternion& q) {
  const double greatest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  const Quaternion s{q.w / greatest, q.x / greatest, q.y / greatest, q.z / greatest};
  const double length = std::sqrt((s.w * s.w + s.x * s.x) + (s.y * s.y + s.z * s.z));
  return {s.w / length, s.x / length, s.y / length, s.z / length};
}

}  // namespace touchstone::fast::motion
