// One run of one simulator, in a process of its own: it may crash and hang.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/motion_scenes.h"
#include "oracle/subject.h"

namespace touchstone::bench {

using Maker = std::function<std::unique_ptr<oracle::Subject>()>;
using Query = Answer<Trajectory> (oracle::Subject::*)(const Scene&);

struct Outcome {
  double seconds = 0;    ///< CPU time of a run
  double error = 0;      ///< as the scene says
  double impacts = -1;   ///< −1: it tells no events
  double changes = -1;   ///< of contacts' modes: contacts and releases; −1 likewise
  std::string left_out;  ///< why there is no figure; else empty
  bool ends = true;      ///< within its time
};

/// A short run is repeated, `rounds` times long enough for the clock; the fastest counts.
Outcome trial(const app::MotionScene& motion, const Maker& maker, Query query, int rounds);

}  // namespace touchstone::bench
