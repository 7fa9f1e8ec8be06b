// Exact changes of bodies in their own frames, for the laws of mass. Return none where doubles would round.
#pragma once

#include <optional>

#include "model/scene.h"

namespace touchstone::properties {

/// Turns each shape in its body's frame so that x → y → z → x. None if a part's quaternion would round.
std::optional<Scene> turned_in_body(Scene scene);

/// Shifts each polytope and compound in its body's frame: p_BBcm → p_BBcm + shift_in_body(body). None if that rounds,
/// or if the scene has a sphere or box, which cannot be away from its origin.
std::optional<Scene> shifted_in_body(Scene scene);
Vec3 shift_in_body(const Body& body);

/// Multiplies each density by 2^k. None if one overflows or underflows.
std::optional<Scene> denser(Scene scene, int k);

}  // namespace touchstone::properties
