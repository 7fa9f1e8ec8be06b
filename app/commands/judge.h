// The command judge: subjects are judged on a scene of one's own.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct JudgeOptions {
  std::string scene;                  ///< a file, - for stdin, or the name of a scene in motion
  std::vector<std::string> subjects;  ///< connectables; if empty, all beside the program
  std::vector<std::string> queries;   ///< if empty, all that the scene has the parts for
  bool json = false;
  double time_limit = 2;  ///< as in RunOptions
};

/// For each query prints the exact truth, and for each subject its answer and the verdict of each property that applies
/// to the scene, with the error beside what is allowed. Returns 1 if a property fails or breaks, else 0. Throws
/// InputError.
int judge(const JudgeOptions& options);

}  // namespace touchstone::app
