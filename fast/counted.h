// A count with its noun.
#pragma once

#include <cstddef>
#include <string>

namespace touchstone::fast {

/// "1 body", "2 bodies": n with `one` if n is 1, else with `many`.
inline std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace touchstone::fast
