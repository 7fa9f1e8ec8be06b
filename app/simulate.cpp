#include "app/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>

#include "app/interruption.h"
#include "app/motion_books.h"
#include "app/motion_run.h"
#include "app/motion_scenes.h"
#include "app/replay_page.h"
#include "app/roster.h"
#include "model/input_error.h"
#include "model/json.h"
#include "model/limits.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t rows_printed = 24;
constexpr int looks_of_a_scene_without_any = 20;

/// In the order of Event::Kind.
constexpr std::array<const char*, 6> kinds = {"impact", "micro_collision", "completed", "contact", "release", "push"};

Scene named_or_file(const std::string& name) {
  for (const MotionScene& known : motion_scenes()) {
    if (known.scene.name == name) return known.scene;
  }
  if (!fs::exists(name)) {
    throw InputError(name, "is neither a file nor a scene of that name (`touchstone list motions` names them)");
  }
  try {
    return reference::completed(read_scene(name));
  } catch (const InputError& error) {
    throw InputError(name, error.what());
  }
}

/// Looks are those of the scene, up to `until` and at it.
void end_at(Scene& scene, double until) {
  if (!scene.flight) {
    scene.flight = Flight{};
    for (int k = 1; k < looks_of_a_scene_without_any; ++k) {
      scene.flight->times.push_back(until * k / looks_of_a_scene_without_any);
    }
  }
  std::vector<double>& times = scene.flight->times;
  std::erase_if(times, [until](double time) { return time >= until; });
  times.push_back(until);
}

Scene scene_of(const SimulateCommand& command) {
  Scene scene = named_or_file(command.scene);
  if (!scene.flight && !command.until) {
    throw InputError(command.scene, "has no flight: say with --until how many seconds to follow it");
  }
  if (command.until) end_at(scene, *command.until);
  validate(scene);
  return scene;
}

/// What would spoil the end of a long run is told before it.
void require_folder_of(const std::string& option, const std::string& path) {
  if (path.empty()) return;
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder)) throw InputError(option, folder.string() + " is no folder");
}

std::size_t impacts_until(const Trajectory& trajectory, double time) {
  return static_cast<std::size_t>(std::ranges::count_if(*trajectory.events, [time](const Event& event) {
    return event.kind == Event::Kind::impact && event.time <= time;
  }));
}

void print_row(double time, const Books& books, const std::string& impacts) {
  const auto& p = books.momentum;
  fmt::print("{:>10.6g} {:>14.8g} {:>14.8g} {:>14.8g}   {:>11.4g} {:>11.4g} {:>11.4g} {:>9}\n", time,
             static_cast<double>(books.kinetic), static_cast<double>(books.potential),
             static_cast<double>(books.energy()), static_cast<double>(p.x()), static_cast<double>(p.y()),
             static_cast<double>(p.z()), impacts);
}

void print_books(const Scene& scene, const MotionRun& run) {
  const BookKeeper keeper(scene);
  fmt::print("{:>10} {:>14} {:>14} {:>14}   {:>35} {:>9}\n", "time s", "kinetic J", "potential J", "energy J",
             "momentum N s (x, y, z)", "impacts");
  const bool starts_at_once = scene.flight->since.empty();
  if (starts_at_once) print_row(0, keeper.at_start(), run.trajectory.events ? "0" : "-");
  const std::size_t looks = run.times.size(), every = (looks + rows_printed - 1) / rows_printed;
  for (std::size_t k = 0; k < looks; ++k) {
    if ((k + 1) % every != 0 && k + 1 != looks) continue;
    const std::string impacts =
        run.trajectory.events ? std::to_string(impacts_until(run.trajectory, run.times[k])) : "-";
    print_row(run.times[k], keeper.at(run.trajectory.states[k]), impacts);
  }
}

void print_events(const Trajectory& trajectory) {
  if (!trajectory.events) {
    fmt::print("events     this engine tells none\n");
    return;
  }
  std::array<std::size_t, kinds.size()> counts{};
  for (const Event& event : *trajectory.events) ++counts[static_cast<std::size_t>(event.kind)];
  std::string line;
  for (std::size_t k = 0; k < kinds.size(); ++k) line += fmt::format("{}{} {}", k > 0 ? ", " : "", kinds[k], counts[k]);
  fmt::print("events     {}\n", line);
  fmt::print("hand-overs {} from flight to contact or within it, {} back to flight\n",
             counts[static_cast<std::size_t>(Event::Kind::contact)],
             counts[static_cast<std::size_t>(Event::Kind::release)]);
}

/// The answer at the looks of `known`, as far as the run has them all.
Trajectory at_looks_of(const Scene& known, const MotionRun& run) {
  Trajectory answer;
  for (const double time : known.flight->times) {
    const auto found = std::ranges::lower_bound(run.times, time);
    if (found == run.times.end() || *found != time) break;
    answer.states.push_back(run.trajectory.states[static_cast<std::size_t>(found - run.times.begin())]);
  }
  return answer;
}

void print_truth(const Scene& scene, const MotionRun& run) {
  const MotionScene* known = known_motion(scene);
  if (known == nullptr) return;
  const Trajectory answer = at_looks_of(known->scene, run);
  if (!answer.states.empty()) fmt::print("truth      {}: off by {:.3g}\n", known->truth, known->error(answer));
}

/// The table's looks alone.
MotionRun without_frames(const Scene& scene, const MotionRun& run) {
  MotionRun looks;
  looks.trajectory.events = run.trajectory.events;
  for (std::size_t k = 0; k < run.times.size(); ++k) {
    if (!std::ranges::binary_search(scene.flight->times, run.times[k])) continue;
    looks.times.push_back(run.times[k]);
    looks.trajectory.states.push_back(run.trajectory.states[k]);
  }
  return looks;
}

std::string lines_of(const std::vector<Event>& events) {
  std::string lines;
  for (const Event& event : events) lines += json_of(event).dump() + "\n";
  return lines;
}

void write(const SimulateCommand& command, const Scene& scene, const MotionRun& run) {
  if (!command.out.empty()) {
    if (!run.trajectory.events) throw InputError(command.engine, "tells no events: there is nothing to write to --out");
    write_text(command.out, lines_of(*run.trajectory.events));
    fmt::print("written    {}\n", command.out);
  }
  if (!command.replay.empty()) {
    write_text(command.replay, replay_page(scene, run.times, run.trajectory));
    fmt::print("written    {}\n", command.replay);
  }
}

/// Why the run ended before the scene's end; the exit code.
int told_end(const Scene& scene, const MotionRun& run) {
  const double end = scene.flight->times.back();
  const double known = run.trajectory.complete_until.value_or(run.times.empty() ? 0 : run.times.back());
  if (run.interrupted) {
    fmt::print(stderr, "touchstone: interrupted; what is known until {} s of {} s is above\n", known, end);
    return interrupted_exit_code;
  }
  if (!run.broke.empty()) {
    fmt::print(stderr, "touchstone: the engine broke ({}); what it said until {} s of {} s is above\n", run.broke,
               known, end);
    return 1;
  }
  if (known < end) fmt::print(stderr, "touchstone: the engine gave up at {} s of {} s\n", known, end);
  return 0;
}

}  // namespace

int simulate(const SimulateCommand& command) {
  const Scene scene = scene_of(command);
  require_folder_of("--out", command.out);
  require_folder_of("--replay", command.replay);
  Scene asked = scene;
  if (!command.replay.empty()) {
    require_replay_library();
    asked.flight->times = with_frames(scene);
  }
  oracle::PipeLimits limits = limits_of(command.time_limit);
  limits.flights = 1;
  limits.longest_line = std::size_t{1} << 30;
  limits.given_up = interrupted;
  const bool constraint = command.engine == "constraint";
  const auto subject = connect(constraint ? "fast" : command.engine, limits);
  const MotionRun run = run_motion(asked, *subject, constraint);

  fmt::print("scene      {}: {} bodies, {} s\n", scene.name.empty() ? command.scene : scene.name, scene.bodies.size(),
             scene.flight->times.back());
  fmt::print("engine     {} {}{}\n", subject->card().name, subject->card().version, constraint ? ", constraint" : "");
  const MotionRun looks = without_frames(scene, run);
  print_books(scene, looks);
  print_events(run.trajectory);
  print_truth(scene, looks);
  write(command, scene, run);
  std::fflush(stdout);
  return told_end(scene, run);
}

}  // namespace touchstone::app
