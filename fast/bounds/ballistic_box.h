// The box that a body in free flight does not leave in a frame.
#pragma once

#include "model/scene.h"

namespace touchstone::fast {

/// Holds the body at every t in [0, duration] (s): its centre of mass moves along c(t) = c + v t + g t²/2, its turning
/// is free and otherwise unknown. On each axis the parabola's least and greatest value, the apex included where it is
/// inside the frame, and around it the ball about c that holds the body; the tight box in its place where the body
/// does not turn (w = 0: without a torque it never will) or is that ball. A fixed body's box at rest.
///
/// Each side is further out than that by at most
///   128 u (max ‖p‖₁ + 3‖c‖₁ + |t|∞ + |v| T + |g| T²/2) + 2^-1050 (1 + T)²
/// (a compound of n parts: (128 + 8 n) u, offsets added). Where no double is large enough, the end is the greatest
/// finite one. Requires duration ≥ 0; throws InputError for one that is not a finite number ≥ 0, and where a density's
/// centre of mass needs faces that are missing. Source: Mirtich & Canny 1995, ballistic trajectories and swept boxes.
Aabb ballistic_box(const Body& body, const Vec3& gravity, double duration);

}  // namespace touchstone::fast
