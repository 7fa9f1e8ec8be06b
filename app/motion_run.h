// One subject's answer about a scene in motion, as far as it came.
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
  std::string broke;          ///< why that is not the end; empty if the subject answered all, or gave up by itself
  bool interrupted = false;
};

/// Asks "simulation", or "constraint". First about 1/64, 1/16 and 1/4 of the looks, which costs a third more in all:
/// who breaks or is interrupted on the way has shown the longest of these. Throws InputError if the subject abstains.
MotionRun run_motion(const Scene& scene, oracle::Subject& subject, bool constraint);

}  // namespace touchstone::app
