// One run of a simulator in a process of its own, since it may crash or hang.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/motion/motion_scenes.h"
#include "oracle/subject.h"

namespace touchstone::bench {

using Maker = std::function<std::unique_ptr<oracle::Subject>()>;
using Query = Answer<Trajectory> (oracle::Subject::*)(const Scene&);

struct Outcome {
  double seconds = 0;    ///< CPU time of one run
  double error = 0;      ///< as the scene defines it
  double impacts = -1;   ///< −1: it reports no events
  double changes = -1;   ///< changes of contact modes: contacts and releases; −1 likewise
  std::string left_out;  ///< why there is no result; otherwise empty
  bool ends = true;      ///< finishes within its time
};

/// A short run is repeated in `rounds` measurements that are long enough for the clock; the fastest counts.
Outcome trial(const app::MotionScene& motion, const Maker& maker, Query query, int rounds);

}  // namespace touchstone::bench
