// One subject's answer about a scene in motion, up to where it came.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/answers.h"
#include "oracle/subject.h"

namespace touchstone::app {

struct MotionRun {
  std::vector<double> times;  ///< s, of the trajectory's states
  Trajectory trajectory;      ///< up to the last time that was reached
  std::string broke;          ///< why the run ended early; empty: full answer, or the subject gave up
  bool interrupted = false;
};

/// Asks "simulation" or "constraint". It asks first about 1/64, 1/16 and 1/4 of the sample times, which costs a third
/// more in total. If the subject breaks or the run is interrupted, the longest of these answers is kept. Throws
/// InputError if the subject abstains.
MotionRun run_motion(const Scene& scene, oracle::Subject& subject, bool constraint);

}  // namespace touchstone::app
