#include "tests/bench/simulation/trial.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <variant>

namespace touchstone::bench {
namespace {

constexpr rlim_t most_seconds = 5;    // per process
constexpr double most_spent = 0.2;    // s, for repeating runs that are too short to measure
constexpr double long_enough = 0.05;  // s

/// The child writes it in one piece.
struct Report {
  double seconds = 0, error = 0, impacts = -1, changes = -1;
  std::array<char, 200> left_out{};
};

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string why_none(const app::MotionScene& motion, const Answer<Trajectory>& answer) {
  if (const auto* abstains = std::get_if<Abstains>(&answer)) return "abstains: " + abstains->why;
  if (const auto* breaks = std::get_if<Breaks>(&answer)) return "broke: " + breaks->how;
  const auto& trajectory = std::get<Trajectory>(answer);
  const double end = motion.scene.motion->sample_times.back();
  if (trajectory.complete_until) return fmt::format("gave up at {:.3g} s of {:.3g} s", *trajectory.complete_until, end);
  if (trajectory.states.size() != motion.scene.motion->sample_times.size()) return "did not answer all samples";
  return std::isfinite(motion.error(trajectory)) ? "" : "answered a number that is not finite";
}

/// The clock has a resolution of milliseconds on some machines, so the query is repeated until the time is measurable.
double seconds_a_run(oracle::Subject& subject, Query query, const Scene& scene, int rounds) {
  double best = INFINITY, spent = 0;
  for (int round = 0, count = 1; round < rounds && spent < most_spent;) {
    const double before = cpu_seconds();
    for (int k = 0; k < count; ++k) static_cast<void>((subject.*query)(scene));
    const double took = cpu_seconds() - before;
    spent += took;
    if (took < long_enough) {
      count *= 4;
    } else {
      best = std::min(best, took / count);
      ++round;
    }
  }
  return best;
}

Report run(const app::MotionScene& motion, const Maker& maker, Query query, int rounds) {
  const auto subject = maker();
  Report report;
  const double before = cpu_seconds();
  const Answer<Trajectory> answer = ((*subject).*query)(motion.scene);
  report.seconds = cpu_seconds() - before;
  const std::string why = why_none(motion, answer);
  std::strncpy(report.left_out.data(), why.c_str(), report.left_out.size() - 1);
  if (!why.empty()) return report;
  const auto& trajectory = std::get<Trajectory>(answer);
  report.error = motion.error(trajectory);
  if (trajectory.events) {
    const auto count = [&](Event::Kind kind) {
      return static_cast<double>(std::ranges::count(*trajectory.events, kind, &Event::kind));
    };
    report.impacts = count(Event::Kind::impact);
    report.changes = count(Event::Kind::contact) + count(Event::Kind::release);
  }
  if (report.seconds < most_spent / 2) report.seconds = seconds_a_run(*subject, query, motion.scene, rounds);
  return report;
}

[[noreturn]] void be_child(int out, const app::MotionScene& motion, const Maker& maker, Query query, int rounds) {
  const rlimit limit{most_seconds, most_seconds + 1};
  setrlimit(RLIMIT_CPU, &limit);
  Report report;
  try {
    report = run(motion, maker, query, rounds);
  } catch (const std::exception& error) {
    std::strncpy(report.left_out.data(), error.what(), report.left_out.size() - 1);
  }
  const bool whole = write(out, &report, sizeof report) == sizeof report;
  _exit(whole ? 0 : 1);
}

}  // namespace

Outcome trial(const app::MotionScene& motion, const Maker& maker, Query query, int rounds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) be_child(ends[1], motion, maker, query, rounds);
  close(ends[1]);
  Report report;
  const bool whole = read(ends[0], &report, sizeof report) == sizeof report;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!whole && WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    return {.left_out = fmt::format("no end within {} s of CPU time", most_seconds), .ends = false};
  }
  if (!whole) return {.left_out = "crashed"};
  return {report.seconds, report.error, report.impacts, report.changes, report.left_out.data()};
}

}  // namespace touchstone::bench
