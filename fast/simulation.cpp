#include "fast/simulation.h"

#include "fast/simulation/loop.h"

namespace touchstone::fast {

namespace {

std::string text(const Stopped& stopped) {
  std::string text = stopped.why + ": bodies[" + std::to_string(stopped.a) + "]";
  return stopped.b < 0 ? text : text + " and bodies[" + std::to_string(stopped.b) + "]";
}

}  // namespace

Simulated simulate(const Scene& scene, const SimulationOptions& options) {
  Simulated done = world::Loop(scene, options).run();
  if (done.stopped) done.trajectory.gave_up = text(*done.stopped);
  return done;
}

Trajectory simulation(const Scene& scene) { return simulate(scene).trajectory; }

}  // namespace touchstone::fast
