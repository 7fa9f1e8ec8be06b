// Tests every moved body against every other: no state, no parameters. Best for a few bodies.
#pragma once

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// Cost of a frame: m·n box tests for m moved bodies of n, n²/2 if all moved.
class AllPairs final : public BroadPhase {
 private:
  void refresh() override;
};

}  // namespace touchstone::fast
