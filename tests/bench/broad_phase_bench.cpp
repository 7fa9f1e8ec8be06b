// Our broad phases and others', side by side: CSV of nanoseconds a body and frame.
//
// touchstone_broad_phase_bench [bodies …] [-w workload]… [-e name-part]… [-r rounds]
// A contestant plays a film forward and backward, a round at a time, in turn with the others; the figure is the median
// of its rounds' CPU time. What is timed: telling the changed boxes, updating, seeing each pair once.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>

#include "tests/bench/broad_phase/contestant.h"
#include "tests/bench/broad_phase/workload.h"

namespace touchstone::bench {
namespace {

struct Options {
  std::vector<std::size_t> bodies;
  std::vector<std::string> workloads;
  std::vector<std::string> entrants;
  int rounds = 5;
};

struct Runner {
  const Entrant* entrant = nullptr;
  std::unique_ptr<Contestant> contestant;
  std::vector<double> ns;
  std::size_t pairs = 0;
};

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Pairs seen in all frames of the round, so that contestants can be compared.
std::size_t play(Contestant& contestant, const Film& film) {
  std::size_t pairs = 0;
  for (const Frame& frame : film.forward) pairs += contestant.pairs_after(frame);
  for (auto frame = film.backward.rbegin(); frame != film.backward.rend(); ++frame)
    pairs += contestant.pairs_after(*frame);
  return pairs;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

std::vector<Entrant> entrants(const Options& options) {
  std::vector<Entrant> all = our_strategies();
  for (const auto& more : {bullet(), fcl_managers(), ode_spaces(), cgal()})
    all.insert(all.end(), more.begin(), more.end());
  const auto wanted = [&](const Entrant& e) {
    return options.entrants.empty() ||
           std::any_of(options.entrants.begin(), options.entrants.end(),
                       [&](const auto& part) { return e.name.find(part) != std::string::npos; });
  };
  all.erase(std::remove_if(all.begin(), all.end(), [&](const Entrant& e) { return !wanted(e); }), all.end());
  return all;
}

void compare(const std::string& workload, std::size_t bodies, const Options& options) {
  const std::size_t frames = bodies <= 10000 ? 64 : 24;
  const Film film = shoot(workload, bodies, frames);
  const std::vector<Entrant> all = entrants(options);
  std::vector<Runner> runners;
  for (const Entrant& entrant : all) {
    if (entrant.quadratic && bodies > 10000) continue;
    runners.push_back({&entrant, entrant.enter(film.start, film.world), {}, 0});
    play(*runners.back().contestant, film);
  }
  for (int round = 0; round < options.rounds; ++round) {
    for (Runner& runner : runners) {
      const double before = cpu_seconds();
      runner.pairs = play(*runner.contestant, film);
      runner.ns.push_back(1e9 * (cpu_seconds() - before) / static_cast<double>(2 * frames * bodies));
    }
  }
  double best_peer = 0;
  for (const Runner& runner : runners)
    if (runner.entrant->peer && (best_peer == 0 || median(runner.ns) < best_peer)) best_peer = median(runner.ns);
  for (const Runner& runner : runners)
    std::printf("%s,%zu,%s,%.1f,%.2f,%.4f\n", workload.c_str(), bodies, runner.entrant->name.c_str(), median(runner.ns),
                best_peer / median(runner.ns),
                static_cast<double>(runner.pairs) / static_cast<double>(2 * frames * bodies));
  std::fflush(stdout);
}

Options read(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool takes_value = words[i] == "-w" || words[i] == "-e" || words[i] == "-r";
    if (takes_value && i + 1 == words.size()) continue;
    if (words[i] == "-w")
      options.workloads.push_back(words[++i]);
    else if (words[i] == "-e")
      options.entrants.push_back(words[++i]);
    else if (words[i] == "-r")
      options.rounds = std::max(1, std::atoi(words[++i].c_str()));
    else
      options.bodies.push_back(std::strtoul(words[i].c_str(), nullptr, 10));
  }
  if (options.bodies.empty()) options.bodies = {1000, 10000, 100000};
  if (options.workloads.empty()) options.workloads = workloads();
  return options;
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  const Options options = read({argv + 1, argv + argc});
  std::printf("workload,bodies,name,ns_per_body_and_frame,times_faster_than_best_peer,pairs_per_body\n");
  for (const std::size_t bodies : options.bodies)
    for (const std::string& workload : options.workloads) compare(workload, bodies, options);
}
