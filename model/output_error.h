// The error for output that cannot be written: a full disk, a closed stdout. Neither wrong input nor a bug; the program
// exits with code 3.
#pragma once

#include <stdexcept>
#include <string>

namespace touchstone {

/// `place` is the file or stream. what() is "place: what_is_wrong".
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& place, const std::string& what_is_wrong)
      : std::runtime_error(place + ": " + what_is_wrong) {}
};

}  // namespace touchstone
