// No engine is judged before its adapter passes `adapter check`, unless asked.
#pragma once

#include <string>
#include <vector>

#include "oracle/process/pipe.h"

namespace touchstone::app {

/// Asks each adapter among the connectables, a subject "exec:...", the scenes of `queries` that are solved on paper
/// (app/adapter/adapter_check.h). Prints what is wrong and throws InputError at the first one that fails. A query is
/// given up after `most_hangs` hangs.
void require_proven_adapters(const std::vector<std::string>& connectables, const std::vector<std::string>& queries,
                             const oracle::PipeLimits& limits);

}  // namespace touchstone::app
