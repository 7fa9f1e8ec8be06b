// Bullet's convex casts, in the precision that this library was built for, asked when two bodies first meet.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// "continuous" (btContinuousConvexCollision), "subsimplex" (btSubsimplexConvexCast) or "gjk_cast" (btGjkConvexCast).
std::unique_ptr<Subject> make_bullet_cast(const std::string& algorithm);

}  // namespace touchstone::oracle::subjects
