// The scenes, by the kind of their motion. Each truth is derived beside its scene.
#pragma once

#include "app/motion/motion_scenes.h"

namespace touchstone::app {

std::vector<MotionScene> bouncing_scenes();
std::vector<MotionScene> rolling_scenes();
MotionScene rattleback();  ///< one of the rolling scenes
std::vector<MotionScene> sliding_scenes();
std::vector<MotionScene> turning_scenes();
std::vector<MotionScene> billiard_scenes();
std::vector<MotionScene> crowd_scenes();
std::vector<MotionScene> resting_scenes();

}  // namespace touchstone::app
