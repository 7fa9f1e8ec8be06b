// The part of an impact in which slip keeps its direction: everything is linear in the normal impulse, or quadratic.
#pragma once

#include "fast/impulse/impact.h"

namespace touchstone::fast::impulse {

enum class Reached { goal, stop };

/// Goes along the line until the goal, or until slip stops, whichever is first.
Reached go_straight(const Impact& impact, const Line& line, const Goal& goal, Course& at);

/// The normal impulse that is left until the goal; infinity if the line never gets there.
double impulse_left(const Impact& impact, const Line& line, const Goal& goal, const Course& at);

}  // namespace touchstone::fast::impulse
