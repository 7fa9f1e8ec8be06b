#include "properties/cases/pair_sets.h"

#include <algorithm>
#include <iterator>

namespace touchstone::properties {

PairSet as_set(PairSet pairs, const Scene& scene) {
  const int n = static_cast<int>(scene.bodies.size());
  for (auto& [i, j] : pairs) {
    if (i > j) std::swap(i, j);
  }
  std::erase_if(pairs, [n](const Pair& pair) { return pair.first < 0 || pair.second >= n; });
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

bool is_well_formed(const PairSet& pairs, const Scene& scene) {
  return pairs == as_set(pairs, scene) && std::ranges::all_of(pairs, [](const Pair& p) { return p.first < p.second; });
}

PairSet without(const PairSet& some, const PairSet& others) {
  PairSet rest;
  std::ranges::set_difference(some, others, std::back_inserter(rest));
  return rest;
}

PairSet difference(const PairSet& some, const PairSet& others) {
  PairSet differ;
  std::ranges::set_symmetric_difference(some, others, std::back_inserter(differ));
  return differ;
}

}  // namespace touchstone::properties
