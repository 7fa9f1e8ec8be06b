// `touchstone simulate`: the trajectory of a scene, by any subject that simulates.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchstone::app {

struct SimulateCommand {
  std::string scene;                ///< a file, or the name of a scene in motion
  std::string engine = "fast";      ///< as in check --subjects or `bench simulation`; "constraint": fast's query
  std::optional<double> until;      ///< s; none: the end of the scene's motion
  std::string out;                  ///< file for the events as JSON lines
  std::string replay;               ///< file for a page that shows the bodies
  std::vector<std::string> beside;  ///< engines whose motions the page shows beside that of `engine`
  double time_limit = 600;          ///< s of CPU time
};

/// fast, constraint, reference, and the short names of the engines that may be built.
std::vector<std::string> engine_names();

/// Prints the energies over time and the number of events of each kind; writes the files. Returns the exit code: 0; 1
/// if the engine breaks or gives up before the end; interrupted_exit_code. In the last two cases the results up to some
/// earlier time are printed and written. Throws InputError, also if the engine abstains, or reports no events although
/// they are to be written, and for engines beside it without a page, of unknown names or named twice. If bodies overlap
/// at the start (app/motion/overlap.h) or a file cannot be written, it throws before the engine is asked.
int simulate(const SimulateCommand& command);

}  // namespace touchstone::app
