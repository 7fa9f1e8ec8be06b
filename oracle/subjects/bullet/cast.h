// Bullet's convex casts as time-of-impact queries, in the precision for which this library is built.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// "continuous" (btContinuousConvexCollision), "subsimplex" (btSubsimplexConvexCast) or "gjk_cast" (btGjkConvexCast).
std::unique_ptr<Subject> make_bullet_cast(const std::string& algorithm);

}  // namespace touchstone::oracle::subjects
