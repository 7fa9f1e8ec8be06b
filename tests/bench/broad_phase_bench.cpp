// Compares our broad phases with those of other libraries: CSV of nanoseconds per body and frame. `touchstone bench
// broad_phase` reads it.
//
// Contestants play a sequence in turn, a round at a time (seat.h); the result is the median of the rounds' CPU time per
// body and frame. Timed: passing the changed boxes, updating, visiting each pair once. A contestant that exceeds its
// budget of 2 CPU seconds plus half a second per round is left out and named.
#include <cstdio>

#include "tests/bench/broad_phase/contestant.h"
#include "tests/bench/broad_phase/laws.h"
#include "tests/bench/broad_phase/seat.h"
#include "tests/bench/broad_phase/workload.h"
#include "tests/bench/command_line.h"

namespace touchstone::bench {
namespace {

std::vector<Entrant> everyone() {
  std::vector<Entrant> all = our_strategies();
  for (const auto& more : {bullet(), fcl_managers(), ode_spaces(), cgal()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

void compare(const std::string& workload, std::size_t bodies, int rounds) {
  const FrameSequence sequence = shoot(workload, bodies, bodies <= 10000 ? 64 : 24);
  const std::vector<Entrant> all = everyone();
  const unsigned budget = 2 + static_cast<unsigned>(rounds) / 2;
  std::vector<std::unique_ptr<Seat>> seats;
  for (const Entrant& entrant : all) seats.push_back(std::make_unique<Seat>(entrant, sequence, budget));
  for (int round = 0; round < rounds; ++round)
    for (const auto& seat : seats) seat->play_round();
  for (const auto& seat : seats) {
    const Entrant& entrant = seat->entrant();
    std::printf("%s,%zu,%s,%s,%s,", workload.c_str(), bodies, entrant.name.c_str(), entrant.peer ? "peer" : "ours",
                entrant.law.c_str());
    if (seat->left_out())
      std::printf(",,did not enter and play within %u CPU seconds\n", budget);
    else
      std::printf("%.1f,%.4f,\n", seat->ns_per_body_and_frame(), seat->pairs_per_body());
  }
  std::fflush(stdout);
}

void run(const Options& options) {
  std::printf("workload,bodies,name,whose,law,ns_per_body_and_frame,pairs_per_body,left_out\n");
  for (const int bodies : options.sizes)
    for (const std::string& workload : options.workloads)
      compare(workload, static_cast<std::size_t>(bodies), options.rounds);
  for (const SwapLaw& law : swap_laws())
    std::printf("swaps.%s,%zu,sweep_and_prune,ours,%s,,%.4f,\n", law.workload.c_str(), law.bodies, law.law.c_str(),
                law.swaps_per_body);
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  return run_comparison(
      argc, argv,
      {"Our broad phases and others', side by side.", "bodies", {{1000, 10000, 100000}, workloads(), 5}, workloads()},
      run);
}
