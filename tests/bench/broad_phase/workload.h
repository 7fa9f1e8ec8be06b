// The eight workloads on which broad phases are compared. Each is a sequence that is played forward and backward.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/broad_phase/contestant.h"

namespace touchstone::bench {

struct FrameSequence {
  std::vector<Aabb> start;
  std::vector<Frame> forward;   ///< frame i leads from snapshot i to i + 1
  std::vector<Frame> backward;  ///< frame i leads from snapshot i + 1 back to i
  Aabb world;                   ///< contains every box of every snapshot
};

/// coherent, settled, flickering, ratio, clustered, teleport, still, announced.
const std::vector<std::string>& workloads();

/// A pure function of its arguments.
FrameSequence shoot(const std::string& workload, std::size_t bodies, std::size_t frames);

}  // namespace touchstone::bench
