// What is said of pairs, as sets.
#pragma once

#include <utility>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::properties {

using Pair = std::pair<int, int>;

/// The same set, as a sorted list of i < j without the pairs that name no body: form is another property's business.
PairSet as_set(PairSet pairs, const Scene& scene);

/// Pairs i < j of bodies, sorted, each once.
bool is_well_formed(const PairSet& pairs, const Scene& scene);

PairSet without(const PairSet& some, const PairSet& others);

/// In one of the two only.
PairSet difference(const PairSet& some, const PairSet& others);

}  // namespace touchstone::properties
