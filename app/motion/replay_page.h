// A page that plays a scene in motion. It loads nothing from the network; three.js draws the bodies.
#pragma once

#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::app {

/// The scene's sample times and, between them, enough frames for a smooth replay; fewer if there are many bodies.
/// Ascending.
std::vector<double> with_frames(const Scene& scene);

/// Throws InputError if three.js is not installed, and says how to get it.
void require_replay_library();

/// `times` are the times of the trajectory's states. Requires a completed scene. Throws as require_replay_library does.
std::string replay_page(const Scene& scene, const std::vector<double>& times, const Trajectory& trajectory);

}  // namespace touchstone::app
