// What was to be written could not be: a full disk, a closed stdout. Neither the input's fault nor a bug; exit code 3.
#pragma once

#include <stdexcept>
#include <string>

namespace touchstone {

class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& place, const std::string& what_is_wrong)
      : std::runtime_error(place + ": " + what_is_wrong) {}
};

}  // namespace touchstone
