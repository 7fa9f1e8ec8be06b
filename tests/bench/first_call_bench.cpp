// Compares `fast` with the exact reference on questions that are asked once: CSV of nanoseconds a question.
//
// The law: no public function of `fast` is slower than the reference's on the same input, from the first call on. Both
// are asked each scene in turn, and nothing is kept from one call to the next. A scene's time is the least CPU time of
// the rounds, with the cost of reading the clock in it; a row has the means over its scenes, and the greatest ratio of
// the two times of one scene. Scenes that one of the two does not answer, or not to the end, are left out and counted.
#include <algorithm>
#include <cstdio>
#include <exception>

#include "model/infinity.h"
#include "tests/bench/command_line.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/first_call/questions.h"

namespace touchstone::bench {
namespace {

constexpr double most_seconds = 2;  // of CPU time a row; a round that has begun is finished

/// The least time of a scene (s) by each of the two.
struct Least {
  double fast = infinity, reference = infinity;
};

/// The time of one call; infinity if it did not answer the whole question.
double time_of(const std::function<bool(const Scene&)>& answer, const Scene& scene) {
  const double before = cpu_seconds();
  try {
    if (!answer(scene)) return infinity;
  } catch (const std::exception&) {
    return infinity;
  }
  return cpu_seconds() - before;
}

std::vector<Least> least_times(const Asked& asked, const std::vector<Scene>& scenes, int rounds) {
  std::vector<Least> least(scenes.size());
  const double start = cpu_seconds();
  for (int round = 0; round < rounds && cpu_seconds() - start < most_seconds; ++round) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      least[i].fast = std::min(least[i].fast, time_of(asked.fast, scenes[i]));
      least[i].reference = std::min(least[i].reference, time_of(asked.reference, scenes[i]));
    }
  }
  return least;
}

void compare(const Asked& asked, const Questions& questions, int count, int rounds) {
  Least sum{0, 0};
  double worst = 0;
  int answered = 0, not_by_fast = 0, not_by_reference = 0;
  for (const Least& least : least_times(asked, questions.scenes, rounds)) {
    not_by_fast += least.fast < infinity ? 0 : 1;
    not_by_reference += least.reference < infinity ? 0 : 1;
    if (!(std::max(least.fast, least.reference) < infinity)) continue;
    ++answered;
    sum.fast += least.fast;
    sum.reference += least.reference;
    worst = std::max(worst, least.fast / least.reference);
  }
  std::printf("%s,%d,%s,", asked.query.c_str(), count, questions.name.c_str());
  if (answered > 0) {
    std::printf("%.0f,%.0f,%.4f,", 1e9 * sum.fast / answered, 1e9 * sum.reference / answered, worst);
  } else {
    std::printf(",,,");
  }
  if (not_by_fast + not_by_reference > 0) {
    std::printf("of %zu scenes fast leaves %d and the reference %d", questions.scenes.size(), not_by_fast,
                not_by_reference);
  }
  std::printf("\n");
  std::fflush(stdout);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Asked& asked : asked_queries()) all.push_back(asked.query);
  return all;
}

void run(const Options& options) {
  std::printf("query,scenes,questions,fast_ns,reference_ns,worst_ratio,left_out\n");
  for (const std::string& query : options.workloads) {
    const Asked& asked = *std::ranges::find(asked_queries(), query, &Asked::query);
    for (const int count : options.sizes) {
      for (const Questions& some : questions(query, count)) compare(asked, some, count, options.rounds);
    }
  }
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  return run_comparison(argc, argv,
                        {"Every query of fast beside the exact reference, on scenes that are asked once.",
                         "scenes a row",
                         {{8}, names(), 5},
                         names()},
                        run);
}
