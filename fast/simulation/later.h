// A predicted contact that is none, or not yet: when the pair is queried again.
#pragma once

#include "fast/simulation/run.h"

namespace touchstone::fast::simulation {

/// The pair is farther apart than predicted. An island continues with shorter steps, within which its represented
/// trajectories are more accurate.
void recheck(Run& run, BodyId a, BodyId b);

/// The pair touches but separates, perhaps no faster than rounding can resolve. It is queried again after a time in
/// which the two cannot approach noticeably; with a body in an island, after the current steps (simulation.md).
void schedule_later(Run& run, BodyId a, BodyId b, const Touch& touch);

}  // namespace touchstone::fast::simulation
