// The next impact of a pair in flight.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>

#include "model/scene.h"
#include "reference/time_of_impact.h"

namespace touchstone::reference {

/// A tumbling body is not known any more (reference/flight.h).
struct Lost : std::runtime_error {
  Lost() : std::runtime_error("a tumbling body is not known any more") {}
};

/// The body at a time of its flight, to the nearest doubles or so. Throws Lost.
Body moved(const Scene& scene, std::size_t body, double time);

struct NextImpact {
  bool known = true;                                      ///< false: the pair's future is not known after `time`
  double time = std::numeric_limits<double>::infinity();  ///< s; infinite: none in this flight
  bool rattles = false;  ///< they start within the envelope, and have not been seen to leave it before `time`
};

/// Within half the envelope and approaching: proved apart by at least that, or not approaching, at all times before.
/// Two that start nearer than that (they just had an impact, as a rule) and part may go apart and come back, or come
/// nearer still: by a 64th of their gap. Requires two bodies in flight. Throws Lost.
NextImpact next_impact(const Scene& pair, double envelope);

/// Where the impulse acts, for two that stand as their poses say: the midpoint of their closest points, and of several
/// such points where the bodies approach fastest. None if they overlap, or do not approach.
std::optional<Contact> contact(const Scene& pair);

}  // namespace touchstone::reference
