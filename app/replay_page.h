// A scene in motion as one page that fetches nothing: three.js shows the bodies, the reader plays and scrubs.
#pragma once

#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::app {

/// The scene's looks and, between them, as many frames as a film needs; fewer where bodies are many. Ascending.
std::vector<double> with_frames(const Scene& scene);

/// Throws InputError where three.js is not installed, and says how to get it.
void require_replay_library();

/// `times` are those of the trajectory's states. Requires a completed scene. Throws as require_replay_library.
std::string replay_page(const Scene& scene, const std::vector<double>& times, const Trajectory& trajectory);

}  // namespace touchstone::app
