// Our distance query and others', side by side: CSV of nanoseconds a query, and the error that they buy.
//
// touchstone_distance_bench [vertices …] [-w workload]… [-e name-part]… [-r rounds]
// A contestant plays a film of poses, a round at a time, in turn with the others; the figure is the median of its
// rounds' CPU time. Errors are against the exact distance of 200 frames, in ulps (2^-52) of the scene's scale 1 + 3 +
// 1; NaN where a contestant says no distance.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "reference/distance.h"
#include "tests/bench/distance/contestant.h"

namespace touchstone::bench {
namespace {

struct Options {
  std::vector<int> vertices;
  std::vector<std::string> workloads;
  std::vector<std::string> entrants;
  int rounds = 7;
};

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

std::vector<Runner> runners(const Options& options, const Film& film) {
  std::vector<Runner> all;
  for (const auto& some : {ours(), bullet(), fcl_solvers(), libccd()}) {
    for (const Entrant& entrant : some) {
      const bool wanted = options.entrants.empty() ||
                          std::any_of(options.entrants.begin(), options.entrants.end(),
                                      [&](const auto& part) { return entrant.name.find(part) != std::string::npos; });
      if (wanted) all.push_back({entrant, entrant.enter(film.A, film.B), {}, 0, 0});
    }
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

void compare(const std::string& workload, int vertices, const Options& options) {
  const Film film = shoot(workload, vertices, frame_count);
  std::vector<Runner> all = runners(options, film);
  double unused = 0;
  for (Runner& runner : all) judge(runner, film);
  for (int round = 0; round < options.rounds; ++round) {
    for (Runner& runner : all) {
      const double before = cpu_seconds();
      unused += play(*runner.contestant, film);
      runner.ns.push_back(1e9 * (cpu_seconds() - before) / static_cast<double>(film.frames.size()));
    }
  }
  double best_peer = 0;
  for (const Runner& runner : all) {
    if (runner.entrant.peer && (best_peer == 0 || median(runner.ns) < best_peer)) best_peer = median(runner.ns);
  }
  for (const Runner& runner : all) {
    const double ns = median(runner.ns);
    std::printf("%s,%d,%s,%.0f,%.2f,%.2g,%.2g\n", workload.c_str(), vertices, runner.entrant.name.c_str(), ns,
                best_peer / ns, runner.median_error, runner.worst_error);
  }
  std::fflush(stdout);
  if (unused == 1) std::puts("");  // the compiler must not know that nobody reads the answers
}

Options read(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool takes_value = words[i] == "-w" || words[i] == "-e" || words[i] == "-r";
    if (takes_value && i + 1 == words.size()) continue;
    if (words[i] == "-w") {
      options.workloads.push_back(words[++i]);
    } else if (words[i] == "-e") {
      options.entrants.push_back(words[++i]);
    } else if (words[i] == "-r") {
      options.rounds = std::max(1, std::atoi(words[++i].c_str()));
    } else {
      options.vertices.push_back(std::max(4, std::atoi(words[i].c_str())));
    }
  }
  if (options.vertices.empty()) options.vertices = {8, 20, 50, 200, 1000};
  if (options.workloads.empty()) options.workloads = workloads();
  return options;
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  const Options options = read({argv + 1, argv + argc});
  std::printf("workload,vertices,name,ns_per_query,times_faster_than_best_peer,median_error_ulps,worst_error_ulps\n");
  for (const std::string& workload : options.workloads) {
    for (const int vertices : options.vertices) compare(workload, vertices, options);
  }
}
