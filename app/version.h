#pragma once

namespace touchstone::app {

/// As in CMakeLists.txt; a test holds the two together.
inline constexpr const char* version = "0.1.0";

}  // namespace touchstone::app
