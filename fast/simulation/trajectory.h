// Events that give a body a new trajectory: a frame, a velocity, an applied force.
#pragma once

#include "fast/simulation/run.h"

namespace touchstone::fast::simulation {

/// Computes the boxes that enclose the trajectories over the next frame, the pairs whose boxes intersect, and for each
/// pair the lower bound of its time of impact.
void begin_frame(Run& run);

/// Restarts the body's trajectory if its orientation would be lost before the end of the frame. For a tumbling body,
/// and for a ball whose axis turns, a frame may be too long even so; then the run stops.
void keep_orientation(Run& run, BodyId id);

/// The body moves on from the state: in its island, or ballistically. A fixed body is left alone.
void set_trajectory(Run& run, BodyId id, const State& state);

/// The next applied force acts from now on. As after an impact, the body's trajectory, box and predicted contacts are
/// renewed, so that no impact is missed.
void apply_force(Run& run);

}  // namespace touchstone::fast::simulation
