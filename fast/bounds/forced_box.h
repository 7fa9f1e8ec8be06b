// The box that a body does not leave in a frame, whatever a hand or a motor does to it within a known force.
#pragma once

#include "model/scene.h"

namespace touchstone::fast {

/// As fast/bounds/ballistic_box.h, under a further force F(t) of any direction and point of attack with ‖F‖ ≤
/// greatest_force (N): on each axis |c̈ − g| ≤ f = greatest_force/m, so
///   min over t of v t + (g − f) t²/2  ≤  c(t) − c  ≤  max over t of v t + (g + f) t²/2,
/// and both ends are reached by a constant force. The force may spin the body, so it is its ball that moves.
///
/// Error as the ballistic box's, with |g| + f in place of |g| and 64 (1 + n) u f T²/2 more for the mass of a density (n
/// parts). A fixed body's box at rest. Throws InputError for a duration or force that is not a finite number ≥ 0.
/// Source: Hubbard 1995 (bounded acceleration: space-time bounds for interactive scenes).
Aabb forced_box(const Body& body, const Vec3& gravity, double duration, double greatest_force);

}  // namespace touchstone::fast
