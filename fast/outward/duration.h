// Checks the length of a frame.
#pragma once

#include "model/input_error.h"

namespace touchstone::fast::outward {

inline void check_duration(double seconds) {
  if (!(seconds >= 0 && seconds <= 0x1p1000)) throw InputError("duration", "must be a number of seconds, 0 to 2^1000");
}

}  // namespace touchstone::fast::outward
