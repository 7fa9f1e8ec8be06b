// A case file on the bench again: replay it, or cut it down further.
#pragma once

#include <string>

namespace touchstone::app {

struct CaseCommand {
  std::string path;
  std::string subject;  ///< a connectable; the case's own subject if empty, which may not be "exec:..."
  std::string out;  ///< of minimise: where the smaller case goes; beside the old one if empty, smaller.json for stdin
  int budget = 1500;
  bool json = false;
  double time_limit = 2;  ///< as in RunOptions
};

/// A case file names an engine beside the program, never a program: a file from elsewhere must not run commands. Both
/// throw InputError, and say what was not run, where the case's subject is "exec:..." and the command names none.

/// Prints the property, its clauses in words, the exact truth, the subject's answer and the finding. 1 if it fails, 0
/// if it holds (or says nothing). Throws InputError.
int replay(const CaseCommand& command);

/// Writes the smaller case. 1 if the case does not fail, so that there is nothing to cut down; else 0.
int minimise(const CaseCommand& command);

}  // namespace touchstone::app
