// The usual numerical integration of an impact, for comparison with the closed forms and series.
#pragma once

#include <string>
#include <vector>

#include "fast/impulse/solve.h"

namespace touchstone::bench {

/// A method with one setting.
struct Integrator {
  std::string name;
  std::string effort;  ///< 1 is the cheapest
  fast::impulse::Outcome (*solve)(const fast::impulse::Impact& impact, double parameter);
  double parameter = 0;  ///< number of steps until u_n would be 0 without friction, or tolerance relative to |u|
};

/// Poisson's law, finite friction. All methods use the closed form once slip has stopped (fast/impulse/restart.h); they
/// differ before that. In p (the normal impulse) the direction of slip changes at a rate that is infinite at zero slip;
/// in tau, with d tau = dp/|u_t|, all rates are finite.
std::vector<Integrator> integrators();

}  // namespace touchstone::bench
