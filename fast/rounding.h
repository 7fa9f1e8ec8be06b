// The rounding unit of doubles.
#pragma once

namespace touchstone::fast {

/// Rounding to nearest changes a result x by at most u |x|, unless it over- or underflows.
inline constexpr double u = 0x1p-53;

}  // namespace touchstone::fast
