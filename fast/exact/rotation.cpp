#include "fast/exact/rotation.h"

namespace touchstone::fast::exact {

ScaledRotation scaled_rotation(const Quaternion& q) {
  const Dyadic w = q.w, x = q.x, y = q.y, z = q.z, two = 2;
  const Dyadic ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  return {{Vector{ww + xx - yy - zz, two * (x * y - w * z), two * (x * z + w * y)},
           Vector{two * (x * y + w * z), ww - xx + yy - zz, two * (y * z - w * x)},
           Vector{two * (x * z - w * y), two * (y * z + w * x), ww - xx - yy + zz}},
          ww + xx + yy + zz};
}

}  // namespace touchstone::fast::exact
