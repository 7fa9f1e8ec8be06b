// The command vectors: writes the test vectors of a folder anew, adds to them, or says whether they are true.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchstone::app {

struct VectorsCommand {
  std::string folder = "vectors";
  std::vector<std::string> queries;  ///< empty: all
  std::vector<std::string> cases;    ///< case files whose scenes are added
  int draws = 0;                     ///< of each family are added
  std::uint64_t seed = 1;            ///< of the draws
  std::string page;                  ///< an HTML file that shows all vectors; empty: none is written
  bool check = false;                ///< writes nothing
};

/// Returns 0; with `check` 1 if a file is not what would be written. Throws InputError; then nothing is written.
int vectors(const VectorsCommand& command);

}  // namespace touchstone::app
