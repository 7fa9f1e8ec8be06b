// The tight axis-aligned box of each body, conservative in floating point.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// lo_i = min over the body's points p of (R(q/|q|) p + t)_i, hi_i likewise the greatest, each moved outward.
///
/// Law: the box holds the body exactly as it is meant (poses are exact, model/frame.h), and is at most 2E wider a side
/// with
///   E = 16 u (max ‖p‖₁ + |t|∞) + 2^-1060,   u = 2^-53   (a compound's part: twice that, its own offset ‖p_BP‖₁ added).
/// Where no double is large enough, the end is the greatest finite one. Requires a valid scene; faces are not needed.
Bounds bounds(const Scene& scene);

Aabb box(const Body& body);

}  // namespace touchstone::fast
