// The commands report and check: a whole run, and the files that it writes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchstone::app {

/// The files that a run writes; those without a name are not written.
struct RunFiles {
  std::string out;    ///< folder of the report
  std::string shard;  ///< "3/8": only this part of the run, written to `out` instead of a report; empty: all
  std::string json;   ///< the same content in other forms, also without a report
  std::string junit;
  std::string sarif;
};

/// What makes check return 1.
struct PassConditions {
  bool first_failure = false;  ///< the run stops at it
  bool require_answers = false;
  std::string baseline;        ///< the known failures (app/baseline/baseline.h); if empty, none are
  std::string write_baseline;  ///< a file for the failures of this run
  std::string today;           ///< the date that waivers are compared with; if empty, the machine's
};

/// What a run begins with, unless it is asked not to.
struct SkippedProofs {
  bool self_test = false;      ///< does this build answer test vectors as they were published? (app/self_test)
  bool adapter_check = false;  ///< does the adapter of a subject "exec:..." pass scenes solved on paper?
};

struct RunOptions {
  std::vector<std::string> subjects;    ///< connectables; if empty, all beside the program
  std::vector<std::string> queries;     ///< if empty, all
  std::vector<std::string> properties;  ///< if empty, all of the queries
  std::string effort = "quick";
  int cases = 0;  ///< drawn scenes per query; 0: the effort's own number
  std::uint64_t seed = 1;
  int jobs = 0;           ///< threads; 0: one per processor
  double time_limit = 1;  ///< a subject's CPU time per query, s; the effort says how many times that per trajectory
  SkippedProofs skip;
  std::string meshes;  ///< folder; if empty, the known ones
  RunFiles files;
  PassConditions pass;
};

/// Writes index.html, report.json, report.timing.json, atlas.csv, junit.xml and cases/ into `out`, or one shard of the
/// run. But for times the same seed gives the same bytes. Returns 0 whatever it
/// found, 130 if interrupted; then no shard is written.
int report(const RunOptions& options);

struct MergeCommand {
  std::string folder;  ///< of the shards
  int jobs = 0;        ///< as in RunOptions, for minimising
  RunFiles files;
};

/// Writes the report of all shards in a folder; but for times, byte for byte that of one run. Returns what `report`
/// returns. Throws InputError if a shard is missing, cut off or of another run.
int merge(const MergeCommand& command);

/// Prints one line per failing row and, for a single subject, the largest error of each query and its case. Returns 0
/// if every property holds, 1 if one fails or breaks or a required answer is missing, 130 if interrupted. With a
/// baseline a run is compared with it: 0 if no failure is new or worse, or has an expired waiver, and none that it has
/// is gone. If a baseline is only written, failures are no reason for 1.
int check(const RunOptions& options);

}  // namespace touchstone::app
