// Scenes in motion whose future is known: shared by tests, comparisons and documents.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::app {

/// What is known of a scene's future, and how far an answer is from it.
struct MotionScene {
  Scene scene;
  std::string truth;  ///< in words
  /// 0 is right. Relative to a length, a spin or an energy of the scene; the worst of all looks that the answer has.
  std::function<double(const Trajectory&)> error;
};

/// All of them, by name; docs/scenes/motion_NAME.json is the same scene as a file. Each starts without overlap.
const std::vector<MotionScene>& motion_scenes();

/// The one that is this scene at the same or other looks; null if none is.
const MotionScene* known_motion(const Scene& scene);

}  // namespace touchstone::app
