// |q|² R(q/|q|), which takes no division, exactly.
#pragma once

#include <array>

#include "fast/exact/vector.h"

namespace touchstone::fast::exact {

struct ScaledRotation {
  std::array<Vector, 3> rows;
  Dyadic squared_length;  ///< |q|²

  Vector operator*(const Vector& v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
};

ScaledRotation scaled_rotation(const Quaternion& q);

}  // namespace touchstone::fast::exact
