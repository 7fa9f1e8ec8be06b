#include "tests/bench/broad_phase/laws.h"

#include "fast/broad_phase/sweep_and_prune.h"
#include "tests/bench/broad_phase/workload.h"

namespace touchstone::bench {

std::vector<SwapLaw> swap_laws() {
  std::vector<SwapLaw> laws;
  for (const auto& [workload, law] : {std::pair{"coherent", "n^5/3"}, std::pair{"settled", "n^2/2"}}) {
    for (const std::size_t bodies : {500U, 1000U, 2000U, 4000U}) {
      const FrameSequence sequence = shoot(workload, bodies, 8);
      fast::SweepAndPrune sweep;
      for (std::size_t i = 0; i < bodies; ++i) sweep.insert(static_cast<fast::BodyId>(i), sequence.start[i]);
      sweep.update();
      double swaps = 0;
      for (const Frame& frame : sequence.forward) {
        for (const Change& change : frame) sweep.move(static_cast<fast::BodyId>(change.body), change.box);
        sweep.update();
        swaps += static_cast<double>(sweep.swaps());
      }
      const double frames = static_cast<double>(sequence.forward.size());
      laws.push_back({workload, bodies, law, swaps / frames / static_cast<double>(bodies)});
    }
  }
  return laws;
}

}  // namespace touchstone::bench
