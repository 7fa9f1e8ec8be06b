// A predicted contact whose time has come.
#pragma once

#include "fast/simulation/run.h"

namespace touchstone::fast::simulation {

/// Computes the nearest points of the pair again. If the two are in contact: the response (response.h), with new boxes
/// and predictions for both. If the time was only a lower bound: a new bound.
void resolve_contact(Run& run, const PairEvent& pair);

}  // namespace touchstone::fast::simulation
