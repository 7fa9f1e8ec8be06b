#include "app/commands/simulate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/motion/energy_report.h"
#include "app/motion/given_scene.h"
#include "app/motion/motion_run.h"
#include "app/motion/motion_scenes.h"
#include "app/motion/overlap.h"
#include "app/motion/replay_page.h"
#include "app/report/body_name.h"
#include "app/system/interruption.h"
#include "app/system/terminal.h"
#include "app/system/writable.h"
#include "app/trial/subject_list.h"
#include "model/input_error.h"
#include "model/json.h"
#include "model/limits.h"
#include "model/near_names.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t rows_printed = 24;
constexpr int samples_beyond = 20;  // samples added after the scene's own end
constexpr const char* constraint_engine = "constraint";
constexpr std::size_t most_beside = 5;     // a choice: the bodies of more engines are too small on a screen
constexpr double constraint_steps = 4096;  // the least number of steps per motion (fast/constraint.h)

struct ShortName {
  std::string_view name, subject;
};

/// The names used by `bench simulation`.
constexpr std::array<ShortName, 5> short_names = {{{"bullet", "bullet.simulation"},
                                                   {"bullet.tuned", "bullet.simulation_tuned"},
                                                   {"ode", "ode.simulation"},
                                                   {"ode.quick", "ode.simulation_quick"},
                                                   {"simbody", "simbody.simulation"}}};

/// In the order of Event::Kind.
constexpr std::array<const char*, 6> event_kinds = {"impact",  "micro_collision", "completed",
                                                    "contact", "release",         "force"};

/// Keeps the scene's sample times before `until`, adds some after the scene's own end, and makes `until` the last.
void end_at(Scene& scene, double until) {
  if (!scene.motion) scene.motion = Motion{};
  std::vector<double>& times = scene.motion->sample_times;
  const double own_end = times.empty() ? 0 : times.back();
  std::erase_if(times, [until](double time) { return time >= until; });
  for (int k = 1; own_end < until && k < samples_beyond; ++k) {
    times.push_back(own_end + (until - own_end) * k / samples_beyond);
  }
  times.push_back(until);
  times.erase(std::unique(times.begin(), times.end()), times.end());  // the interval may contain too few doubles
}

Scene scene_of(const SimulateCommand& command) {
  GivenScene given = given_scene(command.scene);
  Scene& scene = given.scene;
  if (!scene.motion && !command.until) {
    throw InputError(given.source.name, "has no motion: say with --until how many seconds to follow it");
  }
  if (command.until) end_at(scene, *command.until);
  try {
    validate(scene);
    refuse_overlap(scene);
  } catch (const InputError& error) {
    throw given.located(error);
  }
  return std::move(given.scene);
}

void require_places(const SimulateCommand& command) {
  for (const std::string& file : {command.out, command.replay}) {
    if (!file.empty()) require_writable_file(file);
  }
  if (command.out.empty() || command.replay.empty()) return;
  if (fs::weakly_canonical(fs::absolute(command.out)) == fs::weakly_canonical(fs::absolute(command.replay))) {
    throw InputError("--replay", command.replay + " is the file of --out too; name two");
  }
}

/// The subject that a name of --engine stands for.
std::string subject_of(const std::string& engine) {
  if (engine == constraint_engine) return "fast";
  const auto known = std::ranges::find(short_names, engine, &ShortName::name);
  return known == short_names.end() ? engine : std::string(known->subject);
}

/// The names of all engines that answer; the short name if there is one.
std::vector<std::string> engines() {
  std::vector<std::string> names = {constraint_engine};
  for (const std::string& subject : answering("simulation")) {
    const auto known = std::ranges::find(short_names, subject, &ShortName::subject);
    names.emplace_back(known == short_names.end() ? subject : known->name);
  }
  names.emplace_back("exec:COMMAND LINE");
  return names;
}

std::unique_ptr<oracle::Subject> connect_to(const std::string& engine, double time_limit) {
  oracle::PipeLimits limits = limits_of(time_limit);
  limits.simulation_factor = 1;
  limits.longest_line = std::size_t{1} << 30;
  const std::string subject = subject_of(engine);
  try {
    return connect(subject, limits);
  } catch (const InputError&) {
    if (subject.find(':') != std::string::npos || std::ranges::count(subject_list({}), subject) > 0) throw;
    throw InputError("engine \"" + engine + '"', unknown_among(engine, engines()));
  }
}

/// An engine that is shown, and what it answered.
struct Shown {
  std::string name;
  std::unique_ptr<oracle::Subject> subject;
  MotionRun run = {};

  bool by_constraint() const { return name == constraint_engine; }
  std::string title() const { return subject->card().name + (by_constraint() ? ", constraint" : ""); }
};

/// The command's engine, and those beside it.
std::vector<Shown> shown_engines(const SimulateCommand& command) {
  std::vector<std::string> names = {command.engine};
  if (!command.beside.empty()) {
    if (command.replay.empty()) {
      throw InputError("--beside", "is for the page that shows the motions: say with --replay where to write it");
    }
    for (const std::string& name : subject_list(command.beside)) {
      const auto is_same = [&](const std::string& other) { return subject_of(other) == subject_of(name); };
      const bool both_of_fast = std::ranges::count(names, name) == 0 && subject_of(name) == "fast";
      if (!both_of_fast && std::ranges::any_of(names, is_same))
        throw InputError("--beside", name + " is shown already");
      names.push_back(name);
    }
    if (names.size() > most_beside + 1) {
      throw InputError("--beside", fmt::format("expected at most {} engines, found {}", most_beside, names.size() - 1));
    }
  }
  std::vector<Shown> shown;
  for (const std::string& name : names) shown.push_back({name, connect_to(name, command.time_limit)});
  return shown;
}

/// The command's engine in the middle.
std::string page_of(const Scene& scene, const std::vector<Shown>& shown) {
  std::vector<ReplayRun> runs;
  for (std::size_t k = 1; k < shown.size(); ++k) runs.push_back({shown[k].title(), &shown[k].run});
  const std::size_t middle = runs.size() / 2;
  runs.insert(runs.begin() + static_cast<std::ptrdiff_t>(middle), {shown[0].title(), &shown[0].run});
  return replay_page(scene, runs, middle);
}

std::size_t impacts_until(const Trajectory& trajectory, double time) {
  return static_cast<std::size_t>(std::ranges::count_if(*trajectory.events, [time](const Event& event) {
    return event.kind == Event::Kind::impact && event.time <= time;
  }));
}

void print_row(double time, const Energies& energies, const std::string& impacts) {
  const auto& p = energies.momentum;
  print("{:>10.6g} {:>14.8g} {:>14.8g} {:>14.8g}   {:>11.4g} {:>11.4g} {:>11.4g} {:>9}\n", time,
        static_cast<double>(energies.kinetic), static_cast<double>(energies.potential),
        static_cast<double>(energies.energy()), static_cast<double>(p.x()), static_cast<double>(p.y()),
        static_cast<double>(p.z()), impacts);
}

void print_energies(const Scene& scene, const MotionRun& run) {
  const EnergyReport report(scene);
  print("{:>10} {:>14} {:>14} {:>14}   {:>35} {:>9}\n", "time s", "kinetic J", "potential J", "energy J",
        "momentum N s (x, y, z)", "impacts");
  const bool starts_at_once = scene.motion->start_times.empty();
  if (starts_at_once) print_row(0, report.at_start(), run.trajectory.events ? "0" : "-");
  const std::size_t samples = run.times.size(), every = (samples + rows_printed - 1) / rows_printed;
  for (std::size_t k = 0; k < samples; ++k) {
    if ((k + 1) % every != 0 && k + 1 != samples) continue;
    const std::string impacts =
        run.trajectory.events ? std::to_string(impacts_until(run.trajectory, run.times[k])) : "-";
    print_row(run.times[k], report.at(run.trajectory.states[k]), impacts);
  }
}

void print_events(const Trajectory& trajectory) {
  if (!trajectory.events) {
    print("events     this engine reports none\n");
    return;
  }
  std::array<std::size_t, event_kinds.size()> counts{};
  for (const Event& event : *trajectory.events) ++counts[static_cast<std::size_t>(event.kind)];
  std::string line;
  for (std::size_t k = 0; k < event_kinds.size(); ++k)
    line += fmt::format("{}{} {}", k > 0 ? ", " : "", event_kinds[k], counts[k]);
  print("events     {}\n", line);
  print("contact    {} changes to contact mode or within it, {} back to ballistic motion\n",
        counts[static_cast<std::size_t>(Event::Kind::contact)], counts[static_cast<std::size_t>(Event::Kind::release)]);
}

void print_solver(const Trajectory& trajectory) {
  if (!trajectory.contact_solver) return;
  const auto& [steps, unconverged, residual] = *trajectory.contact_solver;
  print("solver     {} contact steps, {} not converged, greatest residual {:.3g} m\n", steps, unconverged, residual);
}

/// The answer at the sample times of `known`, as far as the run contains all of them.
Trajectory at_sample_times_of(const Scene& known, const MotionRun& run) {
  Trajectory answer;
  for (const double time : known.motion->sample_times) {
    const auto found = std::ranges::lower_bound(run.times, time);
    if (found == run.times.end() || *found != time) break;
    answer.states.push_back(run.trajectory.states[static_cast<std::size_t>(found - run.times.begin())]);
  }
  return answer;
}

void print_truth(const Scene& scene, const MotionRun& run) {
  const MotionScene* known = known_motion(scene);
  if (known == nullptr) return;
  const Trajectory answer = at_sample_times_of(known->scene, run);
  if (answer.states.empty()) return;
  print("truth      {}: off by {:.3g} until {} s\n", known->truth, known->error(answer),
        known->scene.motion->sample_times[answer.states.size() - 1]);
}

/// The run at the table's sample times only.
MotionRun without_frames(const Scene& scene, const MotionRun& run) {
  MotionRun samples;
  samples.trajectory.events = run.trajectory.events;
  for (std::size_t k = 0; k < run.times.size(); ++k) {
    if (!std::ranges::binary_search(scene.motion->sample_times, run.times[k])) continue;
    samples.times.push_back(run.times[k]);
    samples.trajectory.states.push_back(run.trajectory.states[k]);
  }
  return samples;
}

std::string json_lines(const std::vector<Event>& events) {
  std::string lines;
  for (const Event& event : events) lines += json_of(event).dump() + "\n";
  return lines;
}

void write(const std::string& file, const std::string& text) {
  write_text(file, text);
  print("written    {}\n", file);
}

/// If gravity moves a body by more than its size in one step, the body can pass through others between two samples.
void warn_of_long_steps(const Scene& scene) {
  const double step = scene.motion->sample_times.back() / constraint_steps,
               fall = scene.gravity.norm() * step * step / 2;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (std::holds_alternative<Fixed>(body.mass) || fall <= size(body.shape)) continue;
    complain(
        "in a step of {:.3g} s gravity moves {} by {:.3g} m, more than its size: contacts are "
        "missed; ask for a shorter motion (--until)",
        step, body_name(scene, static_cast<int>(i)), fall);
    return;
  }
}

/// Reports why the run ended before the scene's end. Returns the exit code.
int report_end(const Scene& scene, const MotionRun& run, const std::string& engine) {
  const double end = scene.motion->sample_times.back();
  const double known = run.trajectory.complete_until.value_or(run.times.empty() ? 0 : run.times.back());
  if (run.interrupted) {
    complain("interrupted; what is known until {} s of {} s is above", known, end);
    return interrupted_exit_code();
  }
  if (!run.broke.empty()) {
    complain("{} broke ({}); what it said until {} s of {} s is above", engine, run.broke, known, end);
    return 1;
  }
  if (known < end) {
    const std::string& why = run.trajectory.gave_up;
    complain("{} gave up at {} s of {} s{}{}", engine, known, end, why.empty() ? "" : ": ", why);
    return 1;
  }
  return 0;
}

}  // namespace

std::vector<std::string> engine_names() {
  std::vector<std::string> names = {"fast", constraint_engine, "reference"};
  for (const ShortName& known : short_names) names.emplace_back(known.name);
  return names;
}

int simulate(const SimulateCommand& command) {
  const Scene scene = scene_of(command);
  require_places(command);
  watch_for_interruption();
  Scene asked = scene;
  std::vector<Shown> shown = shown_engines(command);
  if (!command.replay.empty()) {
    require_replay_library();
    asked.motion->sample_times = with_frames(scene, shown.size());
  }
  for (Shown& each : shown) each.run = run_motion(asked, *each.subject, each.by_constraint());
  const auto& [name, subject, run] = shown[0];

  print("scene      {}: {} bodies, {} s\n", scene.name.empty() ? command.scene : scene.name, scene.bodies.size(),
        scene.motion->sample_times.back());
  print("engine     {} {}{}\n", subject->card().name, subject->card().version,
        name == constraint_engine ? ", constraint" : "");
  const MotionRun samples = without_frames(scene, run);
  print_energies(scene, samples);
  print_events(run.trajectory);
  print_solver(run.trajectory);
  print_truth(scene, samples);
  const std::optional<std::vector<Event>>& events = run.trajectory.events;
  if (!command.replay.empty()) write(command.replay, page_of(scene, shown));
  if (!command.out.empty() && events) write(command.out, json_lines(*events));
  if (shown[0].by_constraint()) warn_of_long_steps(scene);
  int code = 0;
  for (const Shown& each : shown) {
    const int end = report_end(scene, each.run, &each == &shown[0] ? "the engine" : each.name);
    code = std::max(code, end);
    if (each.run.interrupted) break;
  }
  const bool answered = !run.interrupted && run.broke.empty();
  if (answered && !command.out.empty() && !events) {
    throw InputError(command.engine, "reports no events: there is nothing to write to --out");
  }
  return code;
}

}  // namespace touchstone::app
