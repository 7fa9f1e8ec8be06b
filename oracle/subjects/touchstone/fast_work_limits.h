// What `fast` and its prepared pairs promise about the work for an answer.
#pragma once

#include <vector>

#include "oracle/work.h"

namespace touchstone::oracle::subjects {

/// Regression pins, not truths: above the most that was counted on drawn scenes, by a half to a few times.
std::vector<WorkLimit> fast_work_limits();
std::vector<WorkLimit> fast_pairs_work_limits();

}  // namespace touchstone::oracle::subjects
