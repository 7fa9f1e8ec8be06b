// Small changes of where bodies are, for fuzzing: shapes stay, so that a change costs next to nothing.
#pragma once

#include "model/scene.h"
#include "properties/random.h"

namespace touchstone::properties::fuzzing {

/// Moves or turns a body: by an ulp, by 2^-53 to 1 of its size, to a coordinate or a rotation of another, to a plain
/// number; or all bodies by the same power of two, at most 2^40. A body stays where it was if its numbers would leave
/// the range in which the bounds of `oracle/tolerance` hold (2^±100). Requires a completed scene of at least one body,
/// without a motion: a motion must not begin with bodies that overlap.
void displace(Scene& scene, Random& random);

}  // namespace touchstone::properties::fuzzing
