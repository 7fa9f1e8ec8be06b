// report and check: a whole run, and what is written of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchstone::app {

struct RunOptions {
  std::vector<std::string> subjects;    ///< connectables; all beside the program if empty
  std::vector<std::string> stems;       ///< all if empty
  std::vector<std::string> properties;  ///< all of the stems if empty
  std::string effort = "quick";
  int cases = 0;  ///< drawn scenes a stem; the effort's own if 0
  std::uint64_t seed = 1;
  int jobs = 0;           ///< threads; one a processor if 0
  double time_limit = 1;  ///< of a subject's CPU time, s, a question; ten times as much a flight
  std::string out;        ///< folder of the report; check writes none if empty
  std::string json;       ///< besides, or instead: these files
  std::string junit;
  std::string meshes;  ///< folder; the known ones if empty
};

/// Writes index.html, report.json, junit.xml and cases/ into `out`. 0 whatever it found; 130 if interrupted.
int report(const RunOptions& options);

/// One line a failing row; of one subject by itself, each stem's largest error and its case. 0 if every property holds,
/// 1 if one fails or breaks; 130 if interrupted.
int check(const RunOptions& options);

}  // namespace touchstone::app
