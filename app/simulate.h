// `touchstone simulate`: what happens next in a scene, by any subject that says so.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchstone::app {

struct SimulateCommand {
  std::string scene;            ///< a file, or the name of a scene in motion
  std::string engine = "fast";  ///< as under check --subjects or in `bench simulation`; "constraint": fast's query
  std::optional<double> until;  ///< s; none: the scene's own end
  std::string out;              ///< JSON lines of the events
  std::string replay;           ///< a page that shows the bodies
  double time_limit = 600;      ///< s of CPU time
};

/// fast, constraint, reference, and the short names of those that may be built.
std::vector<std::string> engine_names();

/// Prints the books over time and how many events of each kind there were; writes the files. The exit code: 0; 1 if the
/// engine breaks or gives up before the end, or interrupted_exit_code; then what is known until some earlier time is
/// printed and written. Throws InputError, also if the engine abstains, or tells no events where they are to be
/// written; before anything is asked where bodies overlap at the start (app/overlap.h), or a file could not be written.
int simulate(const SimulateCommand& command);

}  // namespace touchstone::app
