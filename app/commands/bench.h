// `touchstone bench`: runs the program of a comparison and plots its results.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct BenchOptions {
  std::string name;
  std::vector<std::string> sizes;      ///< none: the comparison's defaults
  std::vector<std::string> workloads;  ///< none: all
  int rounds = 5;
  std::string out = "bench";
};

/// The names of the comparisons.
std::vector<std::string> benches();

/// Prints the table and writes NAME.csv and NAME.txt (the table) to the folder; most comparisons also write a plot
/// NAME.svg, some a page NAME.md. Returns the exit code. Throws InputError if the comparison was not built.
int bench(const BenchOptions& options);

}  // namespace touchstone::app
