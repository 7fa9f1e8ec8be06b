// The six worlds in which broad phases are compared. Each is a film that is played forward and backward.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/broad_phase/contestant.h"

namespace touchstone::bench {

struct Film {
  std::vector<Aabb> start;
  std::vector<Frame> forward;   ///< frame i leads from picture i to i + 1
  std::vector<Frame> backward;  ///< frame i leads from picture i + 1 back to i
  Aabb world;                   ///< holds every box of every picture
};

/// coherent, settled, ratio, clustered, teleport, still.
const std::vector<std::string>& workloads();

/// A pure function of its arguments.
Film shoot(const std::string& workload, std::size_t bodies, std::size_t frames);

}  // namespace touchstone::bench
