// The subjects of a run, by name: behind a pipe or in this process.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/trial/effort.h"
#include "oracle/process/pipe.h"
#include "oracle/subject.h"

namespace touchstone::app {

/// The limits from a time limit of CPU time per query, s: `simulation_factor` times as much for a trajectory, and in
/// wall-clock time ten times that, and 10 s at least, for a subject that sleeps.
oracle::PipeLimits limits_of(double time_limit, double simulation_factor = patient_simulation_factor);

/// Connects to NAME (a program beside this one), exec:COMMAND LINE, or inproc:reference or inproc:fast. Throws
/// InputError.
std::unique_ptr<oracle::Subject> connect(const std::string& connectable, oracle::PipeLimits limits);

/// The named subjects or, if none is named, all beside the program. Commas separate names, but after "exec:" they
/// belong to the command line.
std::vector<std::string> subject_list(const std::vector<std::string>& asked_for);

/// The subjects beside the program whose cards claim the query.
std::vector<std::string> answering(const std::string& query);

/// Whether the subject runs in this process.
inline bool is_in_process(const std::string& connectable) { return connectable.starts_with("inproc:"); }

/// Makes the subject forget everything: starts a fresh process, if it has one.
void start_afresh(oracle::Subject& subject);

}  // namespace touchstone::app
