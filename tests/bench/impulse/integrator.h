// How an impact is usually integrated: what the closed forms and series are set against.
#pragma once

#include <string>
#include <vector>

#include "fast/impulse/solve.h"

namespace touchstone::bench {

/// A method at one effort.
struct Integrator {
  std::string name;
  std::string effort;  ///< 1 is the cheapest
  fast::impulse::Outcome (*solve)(const fast::impulse::Impact& impact, double parameter);
  double parameter = 0;  ///< steps until u_n would be 0 without friction, or the tolerance relative to |u|
};

/// Poisson's law, finite friction. All of them know what happens once slip has stopped (fast/impulse/restart.h); what
/// differs is how they get there. In p (the normal impulse) the direction of slip turns at a rate that is infinite at
/// slip 0; in tau, with d tau = dp/|u_t|, nothing is.
std::vector<Integrator> integrators();

}  // namespace touchstone::bench
