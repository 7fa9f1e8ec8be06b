// Infinity.
#pragma once

#include <limits>

namespace touchstone {

/// +∞ of IEEE doubles.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace touchstone
