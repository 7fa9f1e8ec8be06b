// Changes of a scene towards degenerate ones, for fuzzing: every result is a valid scene.
//
// A byte that is changed at random makes a scene that is not valid, or a generic one, and generic scenes do not find
// the faults (docs/design/generators.md). So a mutation knows what a scene is: it moves two bodies until they touch
// exactly, gives one the other's rotation, flattens a solid, copies a coordinate, steps by an ulp, takes a body of
// another scene.
#pragma once

#include <string>
#include <vector>

#include "model/scene.h"
#include "oracle/query.h"
#include "properties/random.h"

namespace touchstone::properties::fuzzing {

/// The names of the mutations: "touch", "align", "by_ulps", ...
std::vector<std::string> mutations();

/// The scene after one mutation that is drawn at random; `other` lends bodies, shapes and settings. The result
/// - is valid, and its faces are set;
/// - has the parts that the query needs, and two bodies if it is about two; in a motion no bodies overlap at the start,
///   unless both are fixed and the query is about more;
/// - is ordinary: no length is beyond 2^±100 m, so that the bounds of `oracle/tolerance` hold; it has no more than 16
///   bodies, 64 vertices a part and 4096 pixels, and no faster motion, unless `scene` has.
/// A mutation that would make another scene is not done, and a different one is drawn. After 8 of them the result is
/// `scene` itself.
/// Requires a completed scene with these parts.
Scene mutated(const Scene& scene, const Scene& other, const oracle::Query& query, Random& random);

}  // namespace touchstone::properties::fuzzing
