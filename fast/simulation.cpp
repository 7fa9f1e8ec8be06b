#include "fast/simulation.h"

#include "fast/simulation/loop.h"

namespace touchstone::fast {

Simulated simulate(const Scene& scene, const SimulationOptions& options) { return world::Loop(scene, options).run(); }

Trajectory simulation(const Scene& scene) { return simulate(scene).trajectory; }

}  // namespace touchstone::fast
