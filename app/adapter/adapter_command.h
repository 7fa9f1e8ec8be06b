// Commands on the adapter of an engine: writes the skeleton of one, proves one, or measures where its engine is right.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct AdapterCommand {
  std::string action;                ///< "new", "check" or "domain"
  std::string name;                  ///< of new: the adapter's name; of check and domain: a connectable
  std::string language;              ///< of new
  std::vector<std::string> queries;  ///< of check and domain; empty: all that it claims
  bool json = false;                 ///< of check and domain
  double time_limit = 2;             ///< of check and domain: as in RunOptions
};

const std::vector<std::string>& adapter_actions();

/// new: writes a folder with a skeleton and the library on which it is built; never overwrites. check: prints how the
/// adapter answers scenes that are solved on paper. domain: prints the default domain of the card's precision, and from
/// which power of two to which each property holds (app/adapter/widest_domain.h). Returns 1 if `check` found a fault of
/// the adapter, else 0. Throws InputError.
int adapter(const AdapterCommand& command);

}  // namespace touchstone::app
