// The numbers of a scene that a search may change.
#pragma once

#include <vector>

#include "model/scene.h"

namespace touchstone::app {

/// One number of a scene, and the size of what it belongs to: lengths of a body have the body's size, a component of
/// a quaternion has the quaternion's length, one of a velocity the velocity's, at least 1.
struct SceneNumber {
  double* value = nullptr;
  double scale = 1;
};

/// The poses and shapes of all bodies and their parts; in a scene with a contact or a motion also the velocities of
/// bodies. They stay valid as long as no part of the scene is replaced.
std::vector<SceneNumber> numbers_of(Scene& scene);

}  // namespace touchstone::app
