// Contact regions that share bodies which move.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace touchstone::reference {

/// The bodies of a region that move, none for one that is fixed.
using MovingPair = std::array<std::optional<int>, 2>;

/// The numbers of the given regions, by connected components of the bodies that move; ascending in each. `pairs` are
/// those of all regions.
std::vector<std::vector<std::size_t>> components(const std::vector<MovingPair>& pairs,
                                                 const std::vector<std::size_t>& regions);

}  // namespace touchstone::reference
