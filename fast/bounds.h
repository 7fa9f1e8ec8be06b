// The tight axis-aligned box of each body, conservative in floating point.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// lo_i = min over the body's points p of (R(q/|q|) p + t)_i, hi_i likewise the maximum, each rounded outward.
///
/// Law: the box contains the exact body (poses are exact, model/frame.h), and is wider by at most 2E on each side, with
///   E = 16 u (max ‖p‖₁ + |t|∞) + 2^-1060,   u = 2^-53   (a compound's part: twice that, its own offset ‖p_BP‖₁ added).
/// An end beyond the range of doubles is the greatest finite double. Requires a valid scene; faces are not needed.
Bounds bounds(const Scene& scene);

/// The box of one body, by the same law.
Aabb box(const Body& body);

}  // namespace touchstone::fast
