// Compares our distance query with those of other libraries: CSV of nanoseconds per query, and the errors.
//
// Contestants play a sequence of poses in turn, a round at a time; the result is the median of the rounds' CPU time.
// Of several pairs each has a contestant of its own, and a frame asks about all of them in turn. Errors are differences
// from the exact distance in 200 frames, in ulps (2^-52) of the scene's scale 1 + 3 + 1; NaN if a contestant reports no
// distance.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "reference/distance.h"
#include "tests/bench/command_line.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/distance/contestant.h"
#include "tests/bench/work_precision.h"

namespace touchstone::bench {
namespace {

struct Runner {
  Entrant entrant;
  std::vector<std::unique_ptr<Contestant>> contestants;  ///< by pair
  std::vector<double> ns;
  double median_error = 0;
  double worst_error = 0;
};

constexpr std::size_t frame_count = 2000;
constexpr std::size_t judged_frames = 200;
constexpr double scale = 5;

using Sequences = std::vector<FrameSequence>;

std::vector<Entrant> entrants(const std::string& workload) {
  if (asks_once(workload)) return asked_once();
  std::vector<Entrant> all;
  for (const auto& some : {ours(), bullet(), fcl_solvers(), libccd()}) all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::vector<Runner> runners(const std::string& workload, const Sequences& sequences) {
  std::vector<Runner> all;
  for (const Entrant& entrant : entrants(workload)) {
    all.push_back({entrant, {}, {}, 0, 0});
    for (const FrameSequence& pair : sequences) all.back().contestants.push_back(entrant.enter(pair.A, pair.B));
  }
  return all;
}

double play(Runner& runner, const Sequences& sequences) {
  double sum = 0;
  for (std::size_t frame = 0; frame < sequences[0].frames.size(); ++frame) {
    for (std::size_t pair = 0; pair < sequences.size(); ++pair) {
      sum += runner.contestants[pair]->distance(sequences[pair].frames[frame]);
    }
  }
  return sum;
}

void judge(Runner& runner, const Sequences& sequences) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < judged_frames; ++i) {
    const std::size_t pair = i % sequences.size();
    const FrameSequence::Poses& poses = sequences[pair].frames[i / sequences.size()];
    const Interval exact = reference::distance(scene_of(sequences[pair], poses)).distance;
    errors.push_back(std::abs(runner.contestants[pair]->distance(poses) - exact.lo) / (0x1p-52 * scale));
  }
  runner.worst_error = *std::max_element(errors.begin(), errors.end());
  runner.median_error = median(errors);
}

void compare(const std::string& workload, int vertices, int rounds) {
  const Sequences sequences = shoot(workload, vertices, frame_count);
  const auto queries = static_cast<double>(sequences.size() * sequences[0].frames.size());
  std::vector<Runner> all = runners(workload, sequences);
  double unused = 0;
  for (Runner& runner : all) judge(runner, sequences);
  for (int round = 0; round < rounds; ++round) {
    for (Runner& runner : all) {
      const double before = cpu_seconds();
      unused += play(runner, sequences);
      runner.ns.push_back(1e9 * (cpu_seconds() - before) / queries);
    }
  }
  for (const Runner& runner : all) {
    std::printf("%s,%d,%s,%s,%.1f,%.3g,%.3g,\n", workload.c_str(), vertices, runner.entrant.name.c_str(),
                runner.entrant.whose.c_str(), median(runner.ns), runner.median_error, runner.worst_error);
  }
  std::fflush(stdout);
  if (unused == 1) std::puts("");  // the compiler must not see that the answers are unused
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
                        {"Our distance query and others', side by side, and the error that each buys.",
                         "vertices a body",
                         {{8, 20, 50, 200, 1000}, workloads(), 7},
                         workloads()},
                        run);
}
