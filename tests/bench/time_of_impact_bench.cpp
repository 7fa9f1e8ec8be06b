// Compares our time of impact with those of other libraries: CSV of nanoseconds per question, and the errors.
//
// Hulls of n points of the unit ball, 4 m apart, that close at 4 to 8 m/s and rotate at up to 8 rad/s for 2 s: about
// half of them meet. As screws (equal moments of inertia), where an engine that interpolates poses is asked the same
// question, and tumbling (a density), where ours alone are. A contestant asks about 100 pairs in turn, or about one
// pair again and again (_1); those that are asked about a scene (_once) keep nothing. They run in turn, a round at a
// time; the result is the median of the rounds' CPU time.
//
// Errors, in seconds: the width of an enclosure; without one the difference from the exact time of impact. A wrong
// verdict has the length of the motion.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "reference/time_of_impact.h"
#include "tests/bench/command_line.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/time_of_impact/contestant.h"
#include "tests/bench/work_precision.h"
#include "tests/reference/moving_scenes.h"

namespace touchstone::bench {
namespace {

constexpr int pairs_in_turn = 100;

const std::vector<std::string> workloads{"screws",   "screws_1",   "screws_once",
                                         "tumbling", "tumbling_1", "tumbling_once"};

bool has(const std::string& workload, const char* word) { return workload.find(word) != std::string::npos; }

std::vector<Scene> scenes(const std::string& workload, int vertices) {
  tests::Dice dice(3);
  std::vector<Scene> all;
  for (int i = 0; i < pairs_in_turn; ++i) {
    Scene scene = tests::ballistic_pair(dice, vertices);
    if (has(workload, "tumbling")) {
      for (Body& body : scene.bodies) body.mass = Density{};
    }
    all.push_back(scene);
  }
  if (has(workload, "_1")) {
    const auto meet = [](const Scene& scene) {
      return reference::time_of_impact(scene).status == TimeOfImpact::Status::hit;
    };
    all = {*std::ranges::find_if(all, meet)};
  }
  return all;
}

std::vector<Entrant> entrants(const std::string& workload) {
  if (has(workload, "_once")) return asked_once();
  std::vector<Entrant> all = ours();
  if (has(workload, "screws")) {
    for (const auto& some : {bullet(), fcl()}) all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

double error_of(const TimeOfImpact& said, const reference::TimeOfImpactTruth& truth, double length) {
  if (said.status != truth.status) return length;
  if (said.status != TimeOfImpact::Status::hit) return 0;
  if (said.enclosure) return said.enclosure->hi - said.enclosure->lo;
  return std::abs(*said.time - truth.time.lo);
}

struct Runner {
  Entrant entrant;
  std::vector<Ask> asks;  ///< by pair
  std::vector<double> ns;
  std::vector<double> errors;  ///< of the pairs that meet, or are said to

  void judge(const std::vector<reference::TimeOfImpactTruth>& truths, double length) {
    for (std::size_t i = 0; i < truths.size(); ++i) {
      const TimeOfImpact said = asks[i]();
      const bool miss = TimeOfImpact::Status::miss == said.status && said.status == truths[i].status;
      if (!miss) errors.push_back(error_of(said, truths[i], length));
    }
  }
  int play(int times) {
    int hits = 0;
    for (int i = 0; i < times; ++i) {
      for (const Ask& ask : asks) hits += ask().status == TimeOfImpact::Status::hit ? 1 : 0;
    }
    return hits;
  }
};

void compare(const std::string& workload, int vertices, int rounds) {
  const std::vector<Scene> pairs = scenes(workload, vertices);
  std::vector<reference::TimeOfImpactTruth> truths;
  for (const Scene& scene : pairs) truths.push_back(reference::time_of_impact(scene));
  std::vector<Runner> all;
  for (const Entrant& entrant : entrants(workload)) {
    all.push_back({entrant, {}, {}, {}});
    for (const Scene& scene : pairs) all.back().asks.push_back(entrant.enter(scene));
    all.back().judge(truths, pairs[0].motion->sample_times.back());
  }
  const int times = has(workload, "_1") ? pairs_in_turn : 1;
  int hits = 0;
  for (int round = 0; round < rounds; ++round) {
    for (Runner& runner : all) {
      const double before = cpu_seconds();
      hits += runner.play(times);
      runner.ns.push_back(1e9 * (cpu_seconds() - before) / (times * static_cast<double>(pairs.size())));
    }
  }
  for (const Runner& runner : all) {
    std::printf("%s,%d,%s,%s,%.1f,%.3g,%.3g,\n", workload.c_str(), vertices, runner.entrant.name.c_str(),
                runner.entrant.whose.c_str(), median(runner.ns), median(runner.errors),
                *std::ranges::max_element(runner.errors));
  }
  std::fflush(stdout);
  if (hits < 0) std::puts("");  // the compiler must not see that the answers are unused
}

void run(const Options& options) {
  compare_each(options, [](const std::string& workload, int vertices, int rounds) {
    compare(workload, std::max(vertices, 4), rounds);
  });
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  return run_comparison(argc, argv,
                        {"Our time of impact and others', side by side, and the error that each buys.",
                         "vertices a body",
                         {{8, 20, 50}, workloads, 5},
                         workloads},
                        run);
}
