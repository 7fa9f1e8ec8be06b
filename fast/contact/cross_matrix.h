// The matrix of r×.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::contact {

inline Mat3 cross_matrix(const Vec3& r) {
  Mat3 M;
  M << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return M;
}

}  // namespace touchstone::fast::contact
