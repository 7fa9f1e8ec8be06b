// Commands on a case file: replay it, or minimise it further.
#pragma once

#include <string>

namespace touchstone::app {

struct CaseCommand {
  std::string path;
  std::string subject;  ///< a connectable; if empty, the case's own subject, which must not be "exec:..."
  std::string out;  ///< of minimise: the smaller case; if empty, a file beside the old one, or smaller.json for stdin
  int budget = 1500;
  bool json = false;
  bool trace = false;     ///< of replay: print the lines that are exchanged with the subject, before all else
  double time_limit = 2;  ///< as in RunOptions
};

/// A case file may name an engine beside the program, but no command line, since a file from elsewhere must not run
/// commands. If the case's subject is "exec:..." and the command names no other subject, both functions throw
/// InputError, which says what was not run.

/// Prints the property, its clauses in words, the exact truth, the subject's answer and the finding. Returns 1 if the
/// case fails, 0 if it holds (or the subject abstains). Throws InputError.
int replay(const CaseCommand& command);

/// Writes the smaller case. Returns 1 if the case does not fail, so that there is nothing to minimise; else 0.
int minimise(const CaseCommand& command);

}  // namespace touchstone::app
