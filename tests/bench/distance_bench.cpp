// Our distance query and others', side by side: CSV of nanoseconds a query, and the error that they buy.
//
// A contestant plays a film of poses, a round at a time, in turn with the others; the figure is the median of its
// rounds' CPU time. Errors are against the exact distance of 200 frames, in ulps (2^-52) of the scene's scale 1 + 3 +
// 1; NaN where a contestant says no distance.
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

std::vector<Runner> runners(const Film& film) {
  std::vector<Runner> all;
  for (const auto& some : {ours(), bullet(), fcl_solvers(), libccd()}) {
    for (const Entrant& entrant : some) all.push_back({entrant, entrant.enter(film.A, film.B), {}, 0, 0});
  }
  return all;
}

double play(Contestant& contestant, const Film& film) {
  double sum = 0;
  for (const Film::Poses& poses : film.frames) sum += contestant.distance(poses);
  return sum;
}

void judge(Runner& runner, const Film& film) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < judged_frames; ++i) {
    const Interval exact = reference::distance(scene_of(film, film.frames[i])).distance;
    errors.push_back(std::abs(runner.contestant->distance(film.frames[i]) - exact.lo) / (0x1p-52 * scale));
  }
  runner.worst_error = *std::max_element(errors.begin(), errors.end());
  runner.median_error = median(errors);
}

void compare(const std::string& workload, int vertices, int rounds) {
  const Film film = shoot(workload, vertices, frame_count);
  std::vector<Runner> all = runners(film);
  double unused = 0;
  for (Runner& runner : all) judge(runner, film);
  for (int round = 0; round < rounds; ++round) {
    for (Runner& runner : all) {
      const double before = cpu_seconds();
      unused += play(*runner.contestant, film);
      runner.ns.push_back(1e9 * (cpu_seconds() - before) / static_cast<double>(film.frames.size()));
    }
  }
  for (const Runner& runner : all) {
    std::printf("%s,%d,%s,%s,%.1f,%.3g,%.3g,\n", workload.c_str(), vertices, runner.entrant.name.c_str(),
                runner.entrant.whose.c_str(), median(runner.ns), runner.median_error, runner.worst_error);
  }
  std::fflush(stdout);
  if (unused == 1) std::puts("");  // the compiler must not know that nobody reads the answers
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
