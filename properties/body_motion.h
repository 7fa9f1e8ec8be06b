// Exact changes of bodies in their own frames, for the laws of mass; none where doubles cannot.
#pragma once

#include <optional>

#include "model/scene.h"

namespace touchstone::properties {

/// Each shape turned in its body's frame so that x → y → z → x; none if a part's quaternion would round.
std::optional<Scene> turned_in_body(Scene scene);

/// Each polytope and compound shifted in its body's frame by p_BBcm → p_BBcm + shift_in_body(body); none if that
/// rounds, or if the scene has a sphere or box, which cannot be off its origin.
std::optional<Scene> shifted_in_body(Scene scene);
Vec3 shift_in_body(const Body& body);

/// Each density times 2^k; none if one overflows or underflows.
std::optional<Scene> denser(Scene scene, int k);

}  // namespace touchstone::properties
