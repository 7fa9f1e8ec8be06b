// What happens next? Event after event, all pairs: the obvious loop, for scenes of a few bodies.
//
// Of all pairs, the one that first comes within the envelope and approaches gets its impulse (reference/impulse.h),
// from the bodies' states at that time as they are reported: doubles. docs/design/simulation.md has the definitions,
// and says which freedom an event has.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::reference {

/// Where the reference stops on purpose: events that pile up need a resting contact, which is not its business.
struct SimulationLimits {
  int impacts = 10000;
  int rattles = 64;  ///< impacts of a pair, one after another, between which it does not leave the envelope
};

/// Ends with `complete_until` where a meeting is undecided, events pile up, or a limit is reached: the time until
/// which states and events are whole. Requires a completed scene with a flight; throws what time_of_impact throws.
/// Cost: a time of impact for each pair at the start, and for each pair of the two bodies after each impact.
Trajectory simulation(const Scene& scene, const SimulationLimits& limits = {});

}  // namespace touchstone::reference
