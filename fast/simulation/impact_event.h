// An impulse between two bodies, and the impacts of a pair that have no end.
#pragma once

#include "fast/simulation/run.h"

namespace touchstone::fast::simulation {

/// Applies an impulse, records it, and sets the new trajectories of the two bodies.
void apply_impulse(Run& run, Event::Kind kind, BodyId a, BodyId b, const Touch& touch, ImpactResult result);

/// Counts an impact with the approach speed −u_n. Returns whether the pair collides endlessly: if two bodies touch in a
/// face or an edge and lose energy, an impact at one corner makes the others approach, each time more slowly, and
/// without applied accelerations this never ends. So it does after many impacts between which the two moved no farther
/// than the envelope.
bool collides_endlessly(Run& run, BodyId a, BodyId b, double u_n);

}  // namespace touchstone::fast::simulation
