// The part of an impact in which the direction of slip is constant: everything is linear or quadratic in the normal
// impulse.
#pragma once

#include "fast/impulse/impact.h"

namespace touchstone::fast::impulse {

enum class Reached { goal, stop };

/// Advances along the line until the goal, or until slip stops, whichever is first.
Reached go_straight(const Impact& impact, const Line& line, const Goal& goal, ImpactState& at);

/// The normal impulse that remains until the goal; infinity if the line never reaches it.
double impulse_left(const Impact& impact, const Line& line, const Goal& goal, const ImpactState& at);

}  // namespace touchstone::fast::impulse
