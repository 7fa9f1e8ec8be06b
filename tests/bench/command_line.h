// The command line that all comparisons share; `touchstone bench` uses it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace touchstone::bench {

struct Options {
  std::vector<int> sizes;
  std::vector<std::string> workloads;
  int rounds = 5;
};

/// The options that a comparison accepts.
struct Offer {
  std::string about;
  std::string size;  ///< unit of the sizes: "bodies"
  Options defaults;
  std::vector<std::string> workloads;
};

/// Parses --sizes, --workloads and --rounds, and calls `run`. Returns the exit code: 0, 2 for invalid arguments, 3 if
/// `run` throws.
int run_comparison(int argc, char** argv, const Offer& offer, const std::function<void(const Options&)>& run);

}  // namespace touchstone::bench
