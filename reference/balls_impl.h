// Do one or two balls and some half-spaces have a common point? Exactly.
#pragma once

#include <vector>

#include "reference/half_space_impl.h"

namespace touchstone::reference {

/// Only the square of the radius is rational once a ball is cut by a plane.
struct Ball {
  Triple centre;
  mpq_class squared_radius;
};

/// Let q be a common point of the balls; none, none. If q is in all half-spaces, it is the answer. Else let p be a
/// common point of all: on the way from q to p, which the balls hold, the last half-space is entered through a plane
/// that q is behind. So some such plane holds a common point of all, and cutting the balls by each asks the same in a
/// dimension less.
bool have_common_point(const std::vector<Ball>& balls, const std::vector<HalfSpace>& sides);

}  // namespace touchstone::reference
