// Conservative advancement of two parts: from look to look, each step proved before it is taken.
#pragma once

#include "fast/time_of_impact.h"
#include "fast/time_of_impact/look.h"

namespace touchstone::fast::meeting {

/// As fast/time_of_impact.h, of two parts.
///
/// Far apart, the balls around the two bodies' centres of mass are kept from meeting; near, the slab between the
/// closest features (slab.h): its bound misses the distance by less than a second-order term, so that the time left
/// shrinks quadratically. What is left when rounding hides the gap is looked at a moment later, and twice that, until
/// the two surely overlap (a hit, between the last time at which they were surely apart and this), or surely are apart
/// again (then a doubt is kept, and the advance goes on).
Meeting advance(const Pair& pair, double from, double until, double envelope, lin_canny::FeaturePair& memory);

}  // namespace touchstone::fast::meeting
