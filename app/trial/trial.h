// Asks every subject about every scene under every property, and counts the findings.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/trial/effort.h"
#include "app/trial/ledger.h"
#include "app/trial/meshes.h"
#include "model/json.h"
#include "oracle/process/pipe.h"

namespace touchstone::app {

struct TrialPlan {
  std::vector<std::string> subjects;    ///< how to connect to the subjects
  std::vector<std::string> properties;  ///< ids
  Effort effort;
  std::uint64_t seed = 1;
  int jobs = 1;
  oracle::PipeLimits limits;
  bool first_failure = false;  ///< stop at the first failing scene, and do not make it smaller
  bool profiled = false;       ///< fill the profiles of the ledger, for a report
};

/// A unit of work is a chunk of one query's scenes. The subjects start each unit afresh, and all subjects are asked
/// about a scene in turn, so its exact truth is computed only once; the properties judge one answer of a subject about
/// a scene, except for those that compare two (properties/judging/remembered_answers.h). Units are merged in order, so
/// the ledger does not depend on `jobs`. Then the scene of each failing row is minimised (app/trial/smallest.h). An
/// interrupted run stops early, with a valid ledger.
Ledger run(const TrialPlan& plan, const MeshSet& meshes);

/// One of several runs, perhaps on other machines, that share the units of a plan. 1 ≤ number ≤ of.
struct Shard {
  int number = 1;
  int of = 1;
};

/// What a shard found, as JSON that can be merged (app/units/unit_json.h).
struct ShardResult {
  std::vector<std::string> versions;        ///< name and version of each subject
  std::vector<Json> units;                  ///< empty if the run was interrupted before them
  std::map<std::string, QueryTimes> times;  ///< by query; they are in no unit, so that a unit is the same in each run
};

/// Asks the units that are the shard's. Nothing is minimised.
ShardResult run_shard(const TrialPlan& plan, const MeshSet& meshes, Shard shard);

/// The ledger of `run`, bit for bit if the subjects repeat themselves, from the units of all shards of the same plan:
/// merges them in order, then minimises as `run` does. Throws InputError if a unit is missing or is none of this plan.
Ledger merged(const TrialPlan& plan, const MeshSet& meshes, const std::vector<ShardResult>& shards);

}  // namespace touchstone::app
