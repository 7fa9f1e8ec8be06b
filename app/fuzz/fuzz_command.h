// The command `fuzz`: mutated scenes, guided by coverage and by the nearness of a failure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::app {

struct FuzzCommand {
  std::string query;
  std::string subject;                  ///< a connectable; if empty: inproc:fast, or what answers the query
  std::vector<std::string> properties;  ///< ids; empty: all of the query
  std::optional<long> executions;
  std::optional<double> time;  ///< s; if neither is given, default_fuzz_time
  int enlarge = 0;             ///< questions per finding
  std::uint64_t seed = 1;
  std::string out = "findings";  ///< a folder
  double time_limit = 2;         ///< as in RunOptions
  bool first_failure = false;
  bool empty_corpus = false;  ///< begin with a single scene
  bool json = false;
  bool skip_adapter_check = false;
};

inline constexpr double default_fuzz_time = 60;

/// Prints executions, coverage and findings, and writes a case file for each finding. Returns 0 if there is none, else
/// 1. Throws InputError.
int fuzz(const FuzzCommand& command);

}  // namespace touchstone::app
