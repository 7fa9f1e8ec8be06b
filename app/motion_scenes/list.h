// The scenes by what moves in them. Truths are derived where they stand.
#pragma once

#include "app/motion_scenes.h"

namespace touchstone::app {

std::vector<MotionScene> bouncing_scenes();
std::vector<MotionScene> rolling_scenes();
MotionScene rattleback();  ///< one of them
std::vector<MotionScene> sliding_scenes();
std::vector<MotionScene> turning_scenes();
std::vector<MotionScene> billiard_scenes();
std::vector<MotionScene> crowd_scenes();
std::vector<MotionScene> resting_scenes();

}  // namespace touchstone::app
