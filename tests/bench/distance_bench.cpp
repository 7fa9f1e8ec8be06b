// Compares our distance query with those of other libraries: CSV of nanoseconds per query, and the errors.
//
// Contestants play a sequence of poses in turn, a round at a time; the result is the median of the rounds' CPU time.
// Errors are differences from the exact distance in 200 frames, in ulps (2^-52) of the scene's scale 1 + 3 + 1; NaN if
// a contestant reports no distance.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>

#include "reference/distance.h"
#include "tests/bench/command_line.h"
#include "tests/bench/distance/contestant.h"

namespace touchstone::bench {
namespace {

struct Runner {
  Entrant entrant;
  std::unique_ptr<Contestant> contestant;
  std::vector<double> ns;
  double median_error = 0;
  double worst_error = 0;
};

constexpr std::size_t frame_count = 2000;
constexpr std::size_t judged_frames = 200;
constexpr double scale = 5;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

std::vector<Runner> runners(const FrameSequence& sequence) {
  std::vector<Runner> all;
  for (const auto& some : {ours(), bullet(), fcl_solvers(), libccd()}) {
    for (const Entrant& entrant : some) all.push_back({entrant, entrant.enter(sequence.A, sequence.B), {}, 0, 0});
  }
  return all;
}

double play(Contestant& contestant, const FrameSequence& sequence) {
  double sum = 0;
  for (const FrameSequence::Poses& poses : sequence.frames) sum += contestant.distance(poses);
  return sum;
}

void judge(Runner& runner, const FrameSequence& sequence) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < judged_frames; ++i) {
    const Interval exact = reference::distance(scene_of(sequence, sequence.frames[i])).distance;
    errors.push_back(std::abs(runner.contestant->distance(sequence.frames[i]) - exact.lo) / (0x1p-52 * scale));
  }
  runner.worst_error = *std::max_element(errors.begin(), errors.end());
  runner.median_error = median(errors);
}

void compare(const std::string& workload, int vertices, int rounds) {
  const FrameSequence sequence = shoot(workload, vertices, frame_count);
  std::vector<Runner> all = runners(sequence);
  double unused = 0;
  for (Runner& runner : all) judge(runner, sequence);
  for (int round = 0; round < rounds; ++round) {
    for (Runner& runner : all) {
      const double before = cpu_seconds();
      unused += play(*runner.contestant, sequence);
      runner.ns.push_back(1e9 * (cpu_seconds() - before) / static_cast<double>(sequence.frames.size()));
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
  std::printf("workload,size,name,whose,ns,median_error,worst_error,left_out\n");
  for (const std::string& workload : options.workloads) {
    for (const int vertices : options.sizes) compare(workload, std::max(vertices, 4), options.rounds);
  }
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
