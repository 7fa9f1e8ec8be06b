// Piles of many bodies, one second each: what stands, topples, is struck, rolls and comes to rest.
#pragma once

#include <vector>

#include "app/motion/motion_scenes.h"

namespace touchstone::bench {

/// Each name ends with the number of bodies that move: stack_50. They are not named scenes of the program, since most
/// of them are too long for tests.
const std::vector<app::MotionScene>& piles();

}  // namespace touchstone::bench
