// Who is on trial: subjects by name, behind a pipe or in this process.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "oracle/pipe.h"
#include "oracle/subject.h"

namespace touchstone::app {

/// So much CPU time a question, s, and ten times as much for a flight's many impacts; by the clock ten times as much as
/// that, for one that sleeps.
oracle::PipeLimits limits_of(double time_limit);

/// NAME (a program beside ours), exec:COMMAND LINE, or inproc:reference and inproc:fast. Throws InputError.
std::unique_ptr<oracle::Subject> connect(const std::string& connectable, oracle::PipeLimits limits);

/// The subjects asked for, or all that stand beside the program if none is. Commas separate them, but behind "exec:"
/// they belong to the command line.
std::vector<std::string> roster(const std::vector<std::string>& asked_for);

/// Those beside the program whose cards claim the query.
std::vector<std::string> answering(const std::string& query);

/// Whatever the subject remembers is gone: a fresh process, if it has one.
void start_afresh(oracle::Subject& subject);

}  // namespace touchstone::app
