#include "properties/cases/box_face.h"

#include <cmath>

namespace touchstone::properties {

using oracle::Matrix;
using oracle::Point;
using oracle::Real;

std::optional<Face> face_below(const Body& box, const Point& p) {
  const Matrix R = oracle::rotation_matrix(box.X_WB.q_WB);
  const Point half = std::get<Box>(box.shape).half_extents.cast<Real>(), at = box.X_WB.p_WB.cast<Real>(),
              off = R.transpose() * (p - at);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Index x = (axis + 1) % 3, y = (axis + 2) % 3;
    if (std::abs(off[axis]) <= half[axis] || std::abs(off[x]) >= half[x] || std::abs(off[y]) >= half[y]) continue;
    const Real side = off[axis] > 0 ? 1 : -1;
    Face face;
    face.middle = at + side * half[axis] * R.col(axis);
    face.R_WF << R.col(x), side * R.col(y), side * R.col(axis);
    face.half << half[x], half[y];
    return face;
  }
  return std::nullopt;
}

}  // namespace touchstone::properties
