// The box that a body in ballistic motion does not leave within a frame.
#pragma once

#include "model/scene.h"

namespace touchstone::fast {

/// Contains the body at every t in [0, duration] (s): its centre of mass moves along c(t) = c + v t + g t²/2, and its
/// torque-free rotation is not computed. On each axis the box takes the minimum and maximum of the parabola, including
/// the apex if it lies within the frame, and extends them by the ball about c that contains the body. If the body does
/// not rotate (w = 0: without a torque it never will), or is that ball, its tight box is used instead. For a fixed
/// body: its box at rest.
///
/// Each side is farther out than that by at most
///   128 u (max ‖p‖₁ + 3‖c‖₁ + |t|∞ + |v| T + |g| T²/2) + 2^-1050 (1 + T)²
/// (a compound of n parts: (128 + 8 n) u, offsets added). An end beyond the range of doubles is the greatest finite
/// double. Requires duration ≥ 0. Throws InputError for one that is not a finite number ≥ 0, and if a density's centre
/// of mass needs faces that are missing. Source: Mirtich & Canny 1995, ballistic trajectories and swept boxes.
Aabb ballistic_box(const Body& body, const Vec3& gravity, double duration);

}  // namespace touchstone::fast
