// The error for wrong input: the message names the place and says what would be right. The program exits with code 2.
#pragma once

#include <stdexcept>
#include <string>

namespace touchstone {

/// `place` is a file, a JSON path ("bodies[3].shape.radius"), an option, or "" where the message needs none. what() is
/// "place: what_is_wrong".
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& place, const std::string& what_is_wrong)
      : std::runtime_error(place.empty() ? what_is_wrong : place + ": " + what_is_wrong) {}
};

}  // namespace touchstone
