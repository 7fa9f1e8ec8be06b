// The axes of the world, for tests of contact geometry.
#pragma once

#include "model/scene.h"

namespace touchstone::fast::contact {

inline const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

}  // namespace touchstone::fast::contact
