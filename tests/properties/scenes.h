// A few scenes by hand, each there for a reason: all that the canaries need to show their lies.
#pragma once

#include <string>
#include <vector>

#include "model/scene.h"

namespace touchstone::tests {

/// Completed and valid; names say what they are.
const std::vector<Scene>& scenes();
/// Two bodies that meet.
const std::vector<Scene>& impacts();
/// Balls on tables.
const std::vector<Scene>& tables();
/// Those that a stem's properties are shown on: impacts for "impulse", scenes for the others.
const std::vector<Scene>& scenes_of(const std::string& stem);
/// Of all of them.
const Scene& scene(const std::string& name);

Body body(Shape shape, const Vec3& p_WB, const Quaternion& q_WB = {});
Scene pair(const std::string& name, Body a, Body b);

}  // namespace touchstone::tests
