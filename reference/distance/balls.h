// Exact test: do one or two balls and some half-spaces have a common point?
#pragma once

#include <vector>

#include "reference/hull/half_space.h"

namespace touchstone::reference {

/// The square of the radius is rational; the radius itself may not be, once a plane has cut the ball.
struct Ball {
  Triple centre;
  mpq_class squared_radius;
};

/// Let q be a common point of the balls; if there is none, the answer is no. If q is in all half-spaces, the answer is
/// yes. Otherwise suppose that p is a common point of all. The segment from q to p stays in the balls, and it enters
/// the last half-space through a plane that q is outside of. So one of those planes contains a common point of all.
/// Cutting the balls with each of them gives the same question in one dimension less.
bool have_common_point(const std::vector<Ball>& balls, const std::vector<HalfSpace>& sides);

}  // namespace touchstone::reference
