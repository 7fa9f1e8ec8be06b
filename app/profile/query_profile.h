// What a run learns about the subjects of one query besides verdicts: where they fail, and how long they take.
#pragma once

#include <vector>

#include "app/profile/atlas.h"
#include "app/profile/left_out.h"
#include "app/profile/run_times.h"

namespace touchstone::app {

/// Times differ from run to run, all else does not.
struct QueryTimes {
  std::vector<RunTimes> answers;  ///< by subject
  PlanTimes plans;

  void merge(const QueryTimes& later);
};

struct QueryProfile {
  std::vector<Atlas> atlas;  ///< by subject
  LeftOut left_out;
  QueryTimes times;

  explicit QueryProfile(std::size_t subjects = 0) : atlas(subjects), times{std::vector<RunTimes>(subjects), {}} {}

  void merge(const QueryProfile& later);
};

}  // namespace touchstone::app
