// The length of a vector, by the same sequence of operations on every machine.
#pragma once

#include <cmath>

#include "model/frame.h"

namespace touchstone::fast::simulation {

inline double length(const Vec3& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z()); }

}  // namespace touchstone::fast::simulation
