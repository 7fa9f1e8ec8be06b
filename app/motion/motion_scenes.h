// Scenes in motion with a known future, shared by tests, comparisons and documents.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::app {

/// A scene, what is known of its future, and the error of an answer.
struct MotionScene {
  Scene scene;
  std::string truth;  ///< in words
  /// 0 is right. Relative to a length, a spin or an energy of the scene; the worst over all samples of the answer.
  std::function<double(const Trajectory&)> error;
};

/// All scenes, by name; each is also a file NAME.json below docs/scenes/motion. No bodies overlap at the start.
const std::vector<MotionScene>& motion_scenes();

/// The known scene that equals this one but for its sample times; null if there is none.
const MotionScene* known_motion(const Scene& scene);

}  // namespace touchstone::app
