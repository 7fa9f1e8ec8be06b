// The number of swaps that sweep and prune makes: counted, not timed.
#pragma once

#include <string>
#include <vector>

namespace touchstone::bench {

struct SwapLaw {
  std::string workload;
  std::size_t bodies = 0;
  std::string law;  ///< growth of a frame's swaps, as derived in the literature notes
  double swaps_per_body = 0;
};

/// For the coherent and settled workloads with 500 to 4,000 bodies: the mean of 8 frames.
std::vector<SwapLaw> swap_laws();

}  // namespace touchstone::bench
