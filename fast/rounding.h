// The rounding unit of doubles.
#pragma once

namespace touchstone::fast {

inline constexpr double u = 0x1p-53;

}  // namespace touchstone::fast
