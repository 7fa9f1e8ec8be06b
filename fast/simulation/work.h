// How much a run has cost: counted, so that it is the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fast/mark.h"

namespace touchstone::fast::simulation {

/// The work of a run: how often its thread has marked each place (fast/mark.h) since the run began, times the CPU time
/// of the place (ns, on one computer). The sum is within a factor of two of the time that most costly runs took
/// (docs/measured/simulation.md). Requires that the run stays on its thread.
class Work {
 public:
  Work() : before_(mark_counts) {}
  std::int64_t done() const;  ///< ns
  /// Takes out what was counted for something that is not to count.
  void leave_out(const MarkCounts& counts) {
    for (std::size_t m = 0; m < counts.size(); ++m) before_[m] += counts[m];
  }

 private:
  MarkCounts before_;
};

}  // namespace touchstone::fast::simulation
