// What an impact does: which contact regions act at one time, and their impulses.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"
#include "reference/simultaneous.h"

namespace touchstone::reference {

using BodyPair = std::pair<int, int>;            ///< a < b
using ImpactTimes = std::map<BodyPair, double>;  ///< of the next impact of each pair (s)

/// The events of one time in their order: the velocities after each are those after its impulse and the ones before.
struct ImpactOutcome {
  std::vector<Event> events;
  std::string undecided;  ///< why there is no outcome; else ""
};

/// What the impact of the pair does at `time`, and the impacts that act with it. Together with it act the regions
/// that approach, of all pairs within the envelope that such pairs connect to it through bodies that move and have
/// started. Other impacts act at the same time, each with its own outcome, if they are due (`next`) before the pair
/// would cross the envelope, and pairs within the envelope connect them to it: else the first would change what the
/// second meets. If such an outcome is undecided, it is left to its own time. One region acts by the law of one
/// contact point, at its sliding centre if it slides on to the end, else at its centre of pressure. Several act by
/// rounds until none of them approaches, if they have no friction. The scene is that of all bodies at `time`.
ImpactOutcome impact_outcome(const Scene& then, double time, const BodyPair& pair, double envelope,
                             const ImpactTimes& next);

}  // namespace touchstone::reference
