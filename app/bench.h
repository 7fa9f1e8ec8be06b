// `touchstone bench`: runs a comparison's own program, and draws what it measured.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct BenchOptions {
  std::string name;
  std::vector<std::string> sizes;      ///< none: the comparison's own
  std::vector<std::string> workloads;  ///< none: all
  int rounds = 5;
  std::string out = "bench";
};

/// The comparisons that there are.
std::vector<std::string> benches();

/// Prints the table; writes NAME.csv, NAME.svg and NAME.txt (the table) to the folder, some a page NAME.md too. The
/// exit code. Throws InputError if the comparison was not built.
int bench(const BenchOptions& options);

}  // namespace touchstone::app
