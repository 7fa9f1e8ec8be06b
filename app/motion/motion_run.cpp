#include "app/motion/motion_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <variant>

#include "app/system/interruption.h"
#include "app/system/progress.h"
#include "model/input_error.h"
#include "oracle/judge/judge.h"

namespace touchstone::app {
namespace {

/// The number of sample times of each query, one query after the other.
std::vector<std::size_t> stages(std::size_t samples) {
  std::vector<std::size_t> all;
  for (const std::size_t part : {64, 16, 4, 1}) {
    if (samples / part > (all.empty() ? 0 : all.back())) all.push_back(samples / part);
  }
  return all;
}

/// Checks the form of an answer: one state per body at each sample time, or up to where the subject gave up. Returns ""
/// if it is right.
std::string wrong_form(const Scene& scene, const Trajectory& answer) {
  const std::vector<double>& times = scene.motion->sample_times;
  const auto reached = [&](double until) {
    return static_cast<std::size_t>(std::ranges::upper_bound(times, until) - times.begin());
  };
  const std::size_t expected = answer.complete_until ? reached(*answer.complete_until) : times.size();
  if (answer.states.size() != expected) {
    return fmt::format("answered {} samples where there are {}", answer.states.size(), expected);
  }
  for (const std::vector<State>& states : answer.states) {
    if (states.size() != scene.bodies.size()) {
      return fmt::format("answered {} bodies of {}", states.size(), scene.bodies.size());
    }
  }
  return oracle::judge::finite(answer) ? "" : "answered a number that is not finite";
}

}  // namespace

MotionRun run_motion(const Scene& scene, oracle::Subject& subject, bool constraint) {
  MotionRun run;
  const std::vector<double>& times = scene.motion->sample_times;
  const std::vector<std::size_t> samples = stages(times.size());
  Progress progress(subject.card().name,
                    static_cast<int>(std::accumulate(samples.begin(), samples.end(), std::size_t{0})));
  Scene part = scene;
  for (const std::size_t count : samples) {
    part.motion->sample_times.assign(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(count));
    auto answer = constraint ? subject.constraint(part) : subject.simulation(part);
    run.interrupted = interrupted();
    if (run.interrupted) return run;
    if (const auto* abstains = std::get_if<Abstains>(&answer)) {
      throw InputError(subject.card().name, "does not answer this: " + abstains->why);
    }
    if (const auto* breaks = std::get_if<Breaks>(&answer)) {
      run.broke = breaks->how;
      return run;
    }
    run.broke = wrong_form(part, std::get<Trajectory>(answer));
    if (!run.broke.empty()) return run;
    run.trajectory = std::move(std::get<Trajectory>(answer));
    run.times.assign(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(run.trajectory.states.size()));
    progress.step(fmt::format("{} s of {} s", part.motion->sample_times.back(), times.back()), static_cast<int>(count));
    if (run.trajectory.complete_until) return run;
  }
  return run;
}

}  // namespace touchstone::app
