// A page that plays a scene in motion. It loads nothing from the network; three.js draws the bodies.
#pragma once

#include <string>
#include <vector>

#include "app/motion/motion_run.h"
#include "model/scene.h"

namespace touchstone::app {

/// What one engine answered. The run is not owned.
struct ReplayRun {
  std::string engine;
  const MotionRun* run = nullptr;
};

/// The scene's sample times and, between them, enough frames for a smooth replay; fewer if there are many bodies, or
/// several runs. Ascending.
std::vector<double> with_frames(const Scene& scene, std::size_t runs);

/// Throws InputError if three.js is not installed, and says how to get it.
void require_replay_library();

/// Shows the runs side by side, from the same start and by one clock; how far the bodies of the others are from those
/// of runs[middle]. Requires a completed scene. Throws as require_replay_library does.
std::string replay_page(const Scene& scene, const std::vector<ReplayRun>& runs, std::size_t middle);

}  // namespace touchstone::app
