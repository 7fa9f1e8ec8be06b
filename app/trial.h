// Asks every subject every question under every property, and keeps the books.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/effort.h"
#include "app/ledger.h"
#include "app/meshes.h"
#include "oracle/pipe.h"

namespace touchstone::app {

struct TrialPlan {
  std::vector<std::string> subjects;    ///< connectables
  std::vector<std::string> properties;  ///< ids
  Effort effort;
  std::uint64_t seed = 1;
  int jobs = 1;
  oracle::PipeLimits limits;
};

/// A unit of work is a chunk of one stem's scenes: the subjects start it afresh and are asked inside, so the exact
/// truth of a scene is found once for all of them. Units are merged in their order: the ledger does not depend on
/// `jobs`. Then each failing row's scene is cut down (smallest.h). Stops early, with a valid ledger, when interrupted.
Ledger run(const TrialPlan& plan, const MeshSet& meshes);

}  // namespace touchstone::app
