// Event-driven simulation by the obvious loop: one event after the other over all pairs, for scenes of a few bodies.
//
// The pair that first comes within the envelope and approaches receives its impulse (reference/impulse.h), at the
// centre of pressure of its contact region. Pairs that then approach within the envelope and are connected to it
// through bodies that move act together with it, by the law of docs/design/simultaneous.md; an impact that is due
// before it would cross the envelope, and that bodies within the envelope connect to it, acts at the same time. The
// impulses are computed from the states at that time as they are reported, in doubles. docs/design/simulation.md has
// the definitions and says which freedom an event has.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::reference {

/// Limits at which the reference stops: accumulating events need a resting contact, which it does not model.
struct SimulationLimits {
  int impacts = 10000;
  int micro_bounces = 64;  ///< successive impacts of a pair between which it does not leave the envelope
};

/// Stops early and sets `complete_until` where a contact is undecided, events accumulate, a limit is reached, or
/// several regions act together with friction or with unlike restitution, for which the law leaves the outcome open:
/// states and events are complete until that time. Requires a completed scene with a motion; throws what time_of_impact
/// throws.
/// Cost: one time of impact for each pair at the start, and after each impact one for each pair of the two bodies; at
/// each impact a distance for each body from each that acts in it.
Trajectory simulation(const Scene& scene, const SimulationLimits& limits = {});

}  // namespace touchstone::reference
