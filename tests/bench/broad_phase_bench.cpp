// Our broad phases and others', side by side: CSV of nanoseconds a body and frame. `touchstone bench broad_phase` reads
// it.
//
// touchstone_broad_phase_bench --sizes N[,N…] --workloads NAME[,NAME…] --rounds N
// Contestants play a film in turn, a round at a time (seat.h); the figure is the median of the rounds' CPU time a body
// and frame. What is timed: telling the changed boxes, updating, seeing each pair once. Who does not keep to the budget
// of 2 CPU seconds, and half of one a round, is left out and named.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <sstream>
#include <stdexcept>

#include "tests/bench/broad_phase/contestant.h"
#include "tests/bench/broad_phase/laws.h"
#include "tests/bench/broad_phase/seat.h"
#include "tests/bench/broad_phase/workload.h"

namespace touchstone::bench {
namespace {

struct Options {
  std::vector<std::size_t> sizes{1000, 10000, 100000};
  std::vector<std::string> workloads = bench::workloads();
  int rounds = 5;
};

std::vector<Entrant> everyone() {
  std::vector<Entrant> all = our_strategies();
  for (const auto& more : {bullet(), fcl_managers(), ode_spaces(), cgal()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

void compare(const std::string& workload, std::size_t bodies, int rounds) {
  const Film film = shoot(workload, bodies, bodies <= 10000 ? 64 : 24);
  const std::vector<Entrant> all = everyone();
  const unsigned budget = 2 + static_cast<unsigned>(rounds) / 2;
  std::vector<std::unique_ptr<Seat>> seats;
  for (const Entrant& entrant : all) seats.push_back(std::make_unique<Seat>(entrant, film, budget));
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

std::vector<std::string> split(const std::string& word) {
  std::vector<std::string> parts;
  std::istringstream in(word);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

std::string known(const std::string& workload) {
  const auto& all = workloads();
  if (std::find(all.begin(), all.end(), workload) != all.end()) return workload;
  std::string names;
  for (const std::string& name : all) names += (names.empty() ? "" : ", ") + name;
  throw std::invalid_argument("no workload " + workload + "; there are " + names);
}

std::size_t number(const std::string& word) {
  std::size_t used = 0;
  const unsigned long n = word.empty() || word[0] == '-' ? 0 : std::stoul(word, &used);
  if (used != word.size() || n < 1 || n > 1'000'000) throw std::invalid_argument("expected a number, found " + word);
  return n;
}

Options read(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
    const std::string& value = words[i + 1];
    if (words[i] == "--sizes") {
      options.sizes.clear();
      for (const std::string& n : split(value)) options.sizes.push_back(number(n));
    } else if (words[i] == "--workloads") {
      options.workloads.clear();
      for (const std::string& name : split(value)) options.workloads.push_back(known(name));
    } else if (words[i] == "--rounds") {
      options.rounds = static_cast<int>(number(value));
    } else {
      throw std::invalid_argument("no option " + words[i]);
    }
  }
  return options;
}

void run(const Options& options) {
  std::printf("workload,bodies,name,whose,law,ns_per_body_and_frame,pairs_per_body,left_out\n");
  for (const std::size_t bodies : options.sizes)
    for (const std::string& workload : options.workloads) compare(workload, bodies, options.rounds);
  for (const SwapLaw& law : swap_laws())
    std::printf("swaps.%s,%zu,sweep_and_prune,ours,%s,,%.4f,\n", law.workload.c_str(), law.bodies, law.law.c_str(),
                law.swaps_per_body);
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  try {
    touchstone::bench::run(touchstone::bench::read({argv + 1, argv + argc}));
    return 0;
  } catch (const std::logic_error& error) {
    std::fprintf(stderr, "touchstone: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", error.what());
    return 3;
  }
}
