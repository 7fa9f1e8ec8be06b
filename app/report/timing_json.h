// The times of a run, in files of their own: those of the same seed differ from run to run.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/trial/ledger.h"
#include "model/json.h"
#include "model/json_node.h"

namespace touchstone::app {

/// What a time contains, for readers.
inline constexpr const char* time_contents =
    "CPU time of an answered question. Of a subject in a process of its own: that process, all threads, from the "
    "question to the answer; it reads the question as JSON, makes the engine's objects, asks the engine and writes the "
    "answer. Of a subject in this process (inproc:): the thread, in the call alone.";

/// report.timing.json: for each query and subject how many questions were answered, and the median and the tenths of
/// their times (s).
Json timing_json(const Ledger& ledger);

/// The times of a shard: by query, and there by the subject's place in the run, how many are in which class.
Json json_of(const std::map<std::string, QueryTimes>& times);

/// Throws InputError for what json_of does not write.
std::map<std::string, QueryTimes> read_times(const Json& json, const Node& node);

}  // namespace touchstone::app
