// A few scenes made by hand, each for a reason: together they show the lies of all canaries.
#pragma once

#include <string>
#include <vector>

#include "model/scene.h"

namespace touchstone::tests {

/// Completed and valid scenes; their names describe them.
const std::vector<Scene>& scenes();
/// Impacts of two bodies.
const std::vector<Scene>& impacts();
/// Balls on tables.
const std::vector<Scene>& tables();
/// The scenes for the properties of a query, e.g. impacts for "impulse".
const std::vector<Scene>& scenes_of(const std::string& query);
/// The scene of that name among all of them.
const Scene& scene(const std::string& name);

Body body(Shape shape, const Vec3& p_WB, const Quaternion& q_WB = {});
Scene pair(const std::string& name, Body a, Body b);

}  // namespace touchstone::tests
