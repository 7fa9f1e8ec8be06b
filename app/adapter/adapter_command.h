// Commands on the adapter of an engine: writes the skeleton of one, or proves one.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct AdapterCommand {
  std::string action;                ///< "new" or "check"
  std::string name;                  ///< of new: the adapter's name; of check: a connectable
  std::string language;              ///< of new
  std::vector<std::string> queries;  ///< of check; empty: all that the subject claims
  bool json = false;                 ///< of check
  double time_limit = 2;             ///< of check: as in RunOptions
};

const std::vector<std::string>& adapter_actions();

/// new: writes a folder with a skeleton and the library on which it is built; never overwrites. check: prints how the
/// adapter answers scenes that are solved on paper. Returns 1 if it found a fault of the adapter, else 0. Throws
/// InputError.
int adapter(const AdapterCommand& command);

}  // namespace touchstone::app
