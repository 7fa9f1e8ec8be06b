#include "fast/broad_phase/strategies.h"

#include <algorithm>

#include "fast/broad_phase/all_pairs.h"
#include "fast/broad_phase/bsp.h"
#include "fast/broad_phase/hierarchical_hash.h"
#include "fast/broad_phase/octree.h"
#include "fast/broad_phase/sweep_2d.h"
#include "fast/broad_phase/sweep_and_prune.h"
#include "fast/broad_phase/uniform_grid.h"
#include "fast/broad_phase/wrapped_grid.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

template <class T>
std::unique_ptr<BroadPhase> make() {
  return std::make_unique<T>();
}

}  // namespace

const std::vector<Strategy>& strategies() {
  static const std::vector<Strategy> all{
      {"all_pairs", "every moved body against every other", make<AllPairs>},
      {"sweep_and_prune", "three sorted lists of end points kept between frames", make<SweepAndPrune>},
      {"sweep_2d", "a line sweeps over rectangles, an interval tree holds those it cuts", make<Sweep2d>},
      {"bsp", "space cut at medians by axis-parallel planes", make<Bsp>},
      {"octree", "each box in the smallest cube that holds it", make<Octree>},
      {"uniform_grid", "equal cells, each box in all that it meets", make<UniformGrid>},
      {"hierarchical_hash", "cells on every scale, each box on its own and all coarser ones", make<HierarchicalHash>},
      {"wrapped_grid", "each box in one cell, cells twice as wide as bodies are apart, wrapped onto a small table",
       make<WrappedGrid>},
  };
  return all;
}

const Strategy& find_strategy(const std::string& name) {
  const auto& all = strategies();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Strategy& s) { return s.name == name; });
  if (found != all.end()) return *found;
  std::string names;
  for (const Strategy& s : all) names += (names.empty() ? "" : ", ") + s.name;
  throw InputError("strategy \"" + name + "\"", "is not one of " + names);
}

}  // namespace touchstone::fast
