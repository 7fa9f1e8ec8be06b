// The domain of engines whose documentation and constants state no limits.
#pragma once

#include "oracle/domain.h"

namespace touchstone::oracle::subjects {

/// What is simulated in metres and seconds: bodies from a micrometre to a million kilometres, places within that,
/// speeds from a micrometre a second up to that of light, and a million radians a second. Beyond it an engine is asked,
/// too, and its answers are shown apart (docs/how_to/add_a_subject.md).
inline Domain customary_domain() {
  Domain made;
  made.lengths = Interval{1e-6, 1e9};
  made.reach = 1e9;
  made.speed = 3e8;
  made.angular_speed = 1e6;
  made.lowest_speed = 1e-6;
  return made;
}

}  // namespace touchstone::oracle::subjects
