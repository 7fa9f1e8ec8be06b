// A count with its noun.
#pragma once

#include <cstddef>
#include <string>

namespace touchstone::fast {

inline std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace touchstone::fast
