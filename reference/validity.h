// The laws of a valid scene that need exact arithmetic; model/limits.h has the others.
#pragma once

#include "model/scene.h"

namespace touchstone::reference {

/// Validates (model/limits.h), derives the faces of each polytope that has none, and checks those that are given:
/// plane, convex, outward, closed. Throws InputError naming the place ("bodies[0].shape.faces[3]: wound clockwise seen
/// from outside"). A polytope with a vertex inside its hull, or without volume, is refused.
Scene completed(Scene scene);

}  // namespace touchstone::reference
