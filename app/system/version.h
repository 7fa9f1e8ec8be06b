#pragma once

namespace touchstone::app {

/// The same as in CMakeLists.txt, which a test checks.
inline constexpr const char* version = "0.1.0";

}  // namespace touchstone::app
