// Compares three exact algorithms of the reference with each other, on scenes of the near-degenerate families.
#pragma once

#include <cstdint>

namespace touchstone::app {

/// Draws `pairs` scenes from the families of the distance query in turn, and checks each with reference/agreement.h.
/// Prints one line per family, each disagreement with its scene, and the total. Returns 0 if there is none, else 3,
/// since a disagreement is a fault of Touchstone itself.
int soak(int pairs, std::uint64_t seed, int jobs);

}  // namespace touchstone::app
