// The law of docs/design/simultaneous.md without friction, in normal velocities and impulses: all that it depends on.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "reference/exact/dense.h"
#include "reference/simultaneous/components.h"

namespace touchstone::reference {

/// Contact points and their regions. u changes by K p.
struct NormalContacts {
  struct Region {
    std::vector<std::size_t> points;
    MovingPair moving;  ///< regions that share a body act together
    mpq_class restitution;
  };
  RationalMatrix K;
  RationalVector u;
  std::vector<Region> regions;
};

/// One round: the regions that approached, and the impulses of compression and restitution at all points (0 elsewhere).
struct ImpactRound {
  std::vector<std::size_t> regions;
  RationalVector p, q;
};

/// One round at the velocities u. Of all p with the effect of compression it takes the one with the least
/// Σ pᵀ K p over the regions one by one, the energy of each wrench on its two bodies, where that matters: where
/// regions that act together differ in e. s is the greatest multiple of 2⁻⁶⁴ that the law allows.
/// None if compression has no solution: a body is clamped between others that move.
std::optional<ImpactRound> impact_round(const NormalContacts& contacts);

/// All rounds until no region approaches. Inelastic collapse takes infinitely many: after `most_rounds`, their limit,
/// one compression of all regions (theorem 3 of the design page). With e = 1 this gives up energy, so it is told.
struct ImpactRounds {
  std::vector<ImpactRound> rounds;
  bool completed = false;   ///< the last round is the compression of all regions
  RationalVector impulses;  ///< their sum
};
std::optional<ImpactRounds> impact_rounds(NormalContacts contacts);

}  // namespace touchstone::reference
