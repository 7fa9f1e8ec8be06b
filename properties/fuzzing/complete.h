// Completes a mutated scene. Most of it is as in a scene that is known to be valid, and is not checked again.
#pragma once

#include "model/scene.h"

namespace touchstone::properties::fuzzing {

/// `changed` with the faces of its polytopes, as oracle::with_faces gives them: a polytope without faces gets those of
/// one with the same vertices in `before` or `other`, else those of its exact hull. All rules of a valid scene are
/// checked, but not again for polytopes of these two scenes, and not for a hull. Throws InputError. Requires that
/// `before` and `other` are completed.
Scene completed_after(Scene changed, const Scene& before, const Scene& other);

}  // namespace touchstone::properties::fuzzing
