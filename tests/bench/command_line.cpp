#include "tests/bench/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdio>

namespace touchstone::bench {

int run_comparison(int argc, char** argv, const Offer& offer, const std::function<void(const Options&)>& run) {
  CLI::App program(offer.about + " Prints CSV; `touchstone bench` makes a table and a plot of it.");
  Options options = offer.defaults;
  program.add_option("--sizes", options.sizes, "Numbers of " + offer.size)
      ->delimiter(',')
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  program.add_option("--workloads", options.workloads, "Which of them")
      ->delimiter(',')
      ->check(CLI::IsMember(offer.workloads))
      ->capture_default_str();
  program.add_option("--rounds", options.rounds, "Of which the median is taken")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", error.what());
    return 3;
  }
}

}  // namespace touchstone::bench
