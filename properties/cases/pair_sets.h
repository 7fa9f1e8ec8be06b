// Answers about pairs, as sets.
#pragma once

#include <utility>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::properties {

using Pair = std::pair<int, int>;

/// The set as a sorted list of i < j, without the pairs that name no body: another property checks the form.
PairSet as_set(PairSet pairs, const Scene& scene);

/// Are the pairs sorted, i < j, of existing bodies and each there only once?
bool is_well_formed(const PairSet& pairs, const Scene& scene);

PairSet without(const PairSet& some, const PairSet& others);

/// The pairs in exactly one of the two sets.
PairSet difference(const PairSet& some, const PairSet& others);

}  // namespace touchstone::properties
