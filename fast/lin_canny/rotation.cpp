#include "fast/lin_canny/rotation.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::lin_canny {
namespace {

/// The same rotation by a quaternion whose greatest component is in [1, 2).
Quaternion at_unit_scale(const Quaternion& q) {
  const int shift = -std::ilogb(std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
  return {std::scalbn(q.w, shift), std::scalbn(q.x, shift), std::scalbn(q.y, shift), std::scalbn(q.z, shift)};
}

}  // namespace

Mat3 rotation(const Quaternion& q) {
  const double ww = q.w * q.w;
  const double xx = q.x * q.x;
  const double yy = q.y * q.y;
  const double zz = q.z * q.z;
  const double D = (ww + xx) + (yy + zz);
  if (!(D > 0x1p-64 && D < 0x1p64)) return rotation(at_unit_scale(q));
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

}  // namespace touchstone::fast::lin_canny
