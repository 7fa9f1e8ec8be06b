// The command line that every comparison has; `touchstone bench` speaks it.
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

/// What a comparison can be asked for.
struct Offer {
  std::string about;
  std::string size;  ///< of what: "bodies"
  Options defaults;
  std::vector<std::string> workloads;
};

/// Reads --sizes, --workloads and --rounds, and runs. Returns the exit code: 0, 2 for bad words, 3 for what run throws.
int run_comparison(int argc, char** argv, const Offer& offer, const std::function<void(const Options&)>& run);

}  // namespace touchstone::bench
