#include "app/motion/motion_scenes.h"

#include <algorithm>

#include "app/motion/scenes/list.h"

namespace touchstone::app {
namespace {

std::vector<MotionScene> all() {
  std::vector<MotionScene> scenes;
  for (const auto some : {bouncing_scenes, rolling_scenes, sliding_scenes, turning_scenes, billiard_scenes,
                          crowd_scenes, resting_scenes}) {
    std::ranges::move(some(), std::back_inserter(scenes));
  }
  std::ranges::sort(scenes, {}, [](const MotionScene& one) { return one.scene.name; });
  return scenes;
}

}  // namespace

const std::vector<MotionScene>& motion_scenes() {
  static const std::vector<MotionScene> scenes = all();
  return scenes;
}

const MotionScene* known_motion(const Scene& scene) {
  for (const MotionScene& known : motion_scenes()) {
    if (known.scene.name != scene.name || !scene.motion) continue;
    Scene same = scene;
    same.motion->sample_times = known.scene.motion->sample_times;
    if (same == known.scene) return &known;
  }
  return nullptr;
}

}  // namespace touchstone::app
