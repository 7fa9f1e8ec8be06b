// What an impact does: the contact regions that act at one time, and their impulses.
#pragma once

#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"
#include "reference/simultaneous.h"

namespace touchstone::reference {

/// The regions that approach, of all pairs within the envelope connected to the pair a, b through bodies that move and
/// have started; pairs that do not approach connect too. Sorted by pair. Empty if the pair itself has none. The scene
/// is that of all bodies at `time`.
std::vector<ContactRegion> acting_regions(const Scene& then, double time, int a, int b, double envelope);

/// The events of one time in their order: the velocities after each are those after its impulse and the ones before.
struct ImpactOutcome {
  std::vector<Event> events;
  std::string undecided;  ///< why there is no outcome; else ""
};

/// Regions that share no moving body act apart. One region acts by the law of one contact point, at its sliding centre
/// if it slides on to the end, else at its centre of pressure. Several that share bodies act by rounds until none of
/// them approaches, if they have no friction.
ImpactOutcome impact_outcome(const Scene& then, double time, const std::vector<ContactRegion>& regions);

}  // namespace touchstone::reference
