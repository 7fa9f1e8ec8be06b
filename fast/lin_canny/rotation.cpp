#include "fast/lin_canny/rotation.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::lin_canny {
namespace {

bool is_moderate(double squared_length) { return squared_length > 0x1p-64 && squared_length < 0x1p64; }

double squared_length(const Quaternion& q) { return (q.w * q.w + q.x * q.x) + (q.y * q.y + q.z * q.z); }

/// The same rotation by a quaternion whose greatest component is in [1, 2).
Quaternion scaled(const Quaternion& q) {
  const int shift = -std::ilogb(std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
  return {std::scalbn(q.w, shift), std::scalbn(q.x, shift), std::scalbn(q.y, shift), std::scalbn(q.z, shift)};
}

Mat3 rotation(const Quaternion& q, double D) {
  const double ww = q.w * q.w;
  const double xx = q.x * q.x;
  const double yy = q.y * q.y;
  const double zz = q.z * q.z;
  const double xy = q.x * q.y;
  const double xz = q.x * q.z;
  const double yz = q.y * q.z;
  const double wx = q.w * q.x;
  const double wy = q.w * q.y;
  const double wz = q.w * q.z;
  const double s = 1 / D;
  Mat3 R;
  R << ((ww + xx) - (yy + zz)) * s, 2 * (xy - wz) * s, 2 * (xz + wy) * s,  //
      2 * (xy + wz) * s, ((ww + yy) - (xx + zz)) * s, 2 * (yz - wx) * s,   //
      2 * (xz - wy) * s, 2 * (yz + wx) * s, ((ww + zz) - (xx + yy)) * s;
  return R;
}

}  // namespace

Quaternion at_moderate_scale(const Quaternion& q) { return is_moderate(squared_length(q)) ? q : scaled(q); }

Mat3 rotation(const Quaternion& q) {
  const double D = squared_length(q);
  if (is_moderate(D)) return rotation(q, D);
  const Quaternion moderate = scaled(q);
  return rotation(moderate, squared_length(moderate));
}

}  // namespace touchstone::fast::lin_canny
