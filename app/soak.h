// The oracle on trial by itself: three exact routes over the near-degenerate families.
#pragma once

#include <cstdint>

namespace touchstone::app {

/// Draws `pairs` scenes from the families of the distance stem in turn, and asks reference/agreement.h about each.
/// Prints a line a family, each disagreement with its scene, and the total. 0 if there is none, else 3: our own fault.
int soak(int pairs, std::uint64_t seed, int jobs);

}  // namespace touchstone::app
