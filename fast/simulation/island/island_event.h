// How islands merge, take steps, sleep and release bodies.
#pragma once

#include "fast/simulation/run.h"

namespace touchstone::fast::simulation {

/// The contact points of each pair of parts of two bodies that are within the envelope.
std::vector<PairPoints> contact_points_of(const Run& run, BodyId a, BodyId b);

/// Puts both bodies, with all bodies that they are in contact with, into one island. Returns false if they are out of
/// reach. In the island bodies touch up to the distance `touching` (m), or the envelope if that is more.
bool merge_islands(Run& run, BodyId a, BodyId b, double touching = 0);

/// Ends the current step of the body's island, if it is in one, now.
void cut_step(Run& run, BodyId id);

/// The step of the island with this body ends now as planned. The next one begins after all events of this time.
void finish_step(Run& run, BodyId id);

/// Begins the next step of the island with this body now: releases the bodies whose contacts separate, splits the rest
/// into connected islands, and continues each of these by an impact at its fastest contact point, in closed form,
/// asleep, or by a step.
void begin_step(Run& run, BodyId id);

}  // namespace touchstone::fast::simulation
