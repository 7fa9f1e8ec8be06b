// A report in several runs, on as many machines: each writes a shard, and merge makes the report of all of them.
#pragma once

#include <string>

#include "app/commands/report_command.h"
#include "app/trial/trial.h"

namespace touchstone::app {

/// "3/8". Throws InputError.
Shard shard_of(const std::string& word);

/// The file of a shard in a folder: "shard-3-of-8.jsonl".
std::string shard_file(const std::string& folder, Shard shard);

/// Writes a line with the options of the run, a line for each unit, and a last one; and beside it
/// "shard-3-of-8.timing.json" with the times, so that the shard itself is the same in each run. `subjects` are the
/// connectables that the options stand for.
void write_shard(const std::string& file, Shard shard, const RunOptions& options,
                 const std::vector<std::string>& subjects, const ShardResult& result);

/// What the shards of a folder have in common, and all they found.
struct ReadShards {
  RunOptions options;  ///< of the run: subjects, scenes and limits
  std::vector<ShardResult> shards;
};

/// Times that are missing are no error: they are no result. Throws InputError if a shard is missing (and says how to
/// run it), is cut off, or is of another run.
ReadShards read_shards(const std::string& folder);

}  // namespace touchstone::app
