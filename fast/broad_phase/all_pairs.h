// Every moved body against every other: nothing to keep, nothing to tune. Best for a few bodies.
#pragma once

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// Cost of a frame: m·n box tests for m moved bodies of n, n²/2 when all moved.
class AllPairs final : public BroadPhase {
 private:
  void refresh() override;
};

}  // namespace touchstone::fast
