// Conservative advancement of two parts: a sequence of separation queries, with each step proved safe before it is
// taken.
#pragma once

#include "fast/time_of_impact/first_contact.h"
#include "fast/time_of_impact/separation_query.h"

namespace touchstone::fast::time_of_impact {

/// As fast/time_of_impact/first_contact.h, for two parts.
///
/// Far apart, the balls around the two bodies' centres of mass bound the time without contact. Near, the separating
/// plane of the closest features does (separating_plane.h): its bound misses the distance by less than a second-order
/// term, so the remaining time shrinks quadratically. When rounding hides the gap, the parts are queried again a moment
/// later, then twice that, and so on. This ends when they are proved to overlap (a hit, between the last time at which
/// they were proved separated and this time, or an earlier one: the last interval is halved) or proved separated
/// again (the interval is recorded as a doubt, and the advancement continues).
FirstContact advance(const Pair& pair, double from, double until, double envelope, lin_canny::FeaturePair& memory);

}  // namespace touchstone::fast::time_of_impact
