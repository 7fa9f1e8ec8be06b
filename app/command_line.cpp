#include "app/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "app/ask.h"
#include "app/bench.h"
#include "app/case_commands.h"
#include "app/effort.h"
#include "app/import.h"
#include "app/list.h"
#include "app/plan.h"
#include "app/report_command.h"
#include "app/simulate.h"
#include "app/soak.h"
#include "app/version.h"

namespace touchstone::app {
namespace {

constexpr const char* program_footer = R"(
Examples:
  touchstone report                        every engine beside the program; then open report/index.html
  touchstone check --subjects bullet.double,fcl.libccd --stems distance --junit junit.xml
  touchstone check --subjects "exec:python3 my_engine.py"     your own engine, over JSON lines (docs/protocol.md)
  touchstone replay report/cases/distance.value.bullet.float.json
  touchstone ask distance scene.json       the exact answer, as a rational, with its proof

Exit codes:
  0    done; check: every property holds; replay: the case does not fail
  1    check or replay saw a failure
  2    bad input or usage
  3    our own fault
  130  interrupted: what was asked until then is written, and says that it is partial)";

constexpr const char* run_footer = R"(
Examples:
  touchstone report --effort standard --out nightly
  touchstone check --subjects bullet.double --stems distance,penetration --seed 7
  touchstone check --properties distance.symmetric --cases 5000 --junit junit.xml
  touchstone check --subjects "exec:my_engine --flag a,b" --subjects inproc:reference

A run has one row a property and subject. Exit codes of check: 0 every row holds or abstains, 1 a row fails.
The exit code of report is 0 whatever it found: a report that names failures is a good report.)";

constexpr const char* case_footer = R"(
A case file holds one scene, one property, one subject, and what came of it. Exit code of replay: 1 the case fails
(again), 0 it does not. The subject is asked in a fresh process.)";

constexpr const char* plain_footer = "\nExit code: 0 done, 2 bad input.";

constexpr const char* ask_footer = R"(
Examples:
  touchstone ask distance scene.json
  touchstone import part.stl --out part.json && touchstone ask mass part.json --json

Bodies 0 and 1 are A and B; where there are more, the answer begins with their names. Numbers are read as the exact
rationals that they are; "exact" is a rational number, "nearest" the double next to it, an interval [lo, hi] holds the
exact value. Exit code: 0 done, 2 bad input.)";

constexpr const char* plan_footer = R"(
Examples:
  touchstone plan docs/scenes/swarm.json
  touchstone plan dominoes                                        a scene by name: `touchstone list motions`
  touchstone plan scene.json --json

Few bodies are compared each with each, spheres and boxes have no vertices to climb, a scene that stands needs no memory.
Leaving out changes no pair. Of a scene in motion: what a simulation of it needs. Exit code: 0 done, 2 bad input.)";

constexpr const char* simulate_footer = R"(
Examples:
  touchstone simulate bouncing_ball                               a scene by name: `touchstone list motions`
  touchstone simulate docs/scenes/motion_turntable.json --engine bullet --until 3
  touchstone simulate pool_break --out events.jsonl --replay replay.html
  touchstone simulate scene.json --engine "exec:python3 my_engine.py"

The table has energy and momentum of all bodies that are not fixed; potential energy is 0 at the world's origin. Where a
scene's future is known, the greatest error is told, and until when. The replay page fetches nothing and needs three.js
to be made (Debian: libjs-three). Bodies that overlap at the start are bad input, whatever the engine.
Exit code: 0 done, 1 the engine broke, 2 bad input or the engine does not answer this, 130 interrupted; files and table
then go as far as is known.)";

constexpr const char* bench_footer = R"(
Examples:
  ./touchstone bench broad_phase                                  everything: several minutes
  ./touchstone bench broad_phase --sizes 1000,10000 --workloads coherent,settled --rounds 9 --out coherent
  ./touchstone bench distance                                     and the error that each engine's time buys
  ./touchstone bench impulse                                      work and precision of ways to compute an impact
  ./touchstone bench pixel                                        masks, and what sampling misses
  ./touchstone bench simulation --workloads bouncing_ball,gas     simulators; scenes: `touchstone list motions`

Ours and others' run in turn, in slices of CPU time; a figure is the median of the rounds. Who cannot play one frame
within the budget is left out, and named. Written to the folder: the CSV, the table (.txt) and a plot (.svg).
Exit code: 0 done, 2 bad input, or the comparison was not built.)";

constexpr int largest_count = 1'000'000'000;

struct Asked {
  std::string query;
  std::string scene;
  bool json = false;
};

struct Planned {
  std::string scene;
  bool json = false;
};

struct Imported {
  std::string mesh;
  std::string out;
};

struct Soaked {
  int pairs = 100'000;
  std::uint64_t seed = 1;
  int jobs = 2;
};

/// What the options are read into, a command each; `chosen` does the one that was named.
struct Options {
  RunOptions report;
  RunOptions check;
  CaseCommand replay;
  CaseCommand minimise;
  Asked ask;
  Planned plan;
  SimulateCommand simulate;
  Imported import;
  std::string list;
  Soaked soak;
  BenchOptions bench;
  std::function<int()> chosen;
};

std::string listed(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::vector<std::string> effort_names() {
  std::vector<std::string> names;
  for (const Effort& effort : efforts()) names.push_back(effort.name);
  return names;
}

void add_seed(CLI::App& command, std::uint64_t& seed) {
  command.add_option("--seed", seed, "The same seed, the same result, byte for byte")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

/// CLI11's own ranges let NaN pass.
std::string seconds_up_to(double most, const std::string& word) {
  double seconds = 0;
  const bool right = CLI::detail::lexical_cast(word, seconds) && seconds > 0 && seconds <= most;
  return right ? "" : fmt::format("expected seconds, above 0 and at most {}, found {}", most, word);
}

std::string within_a_day(const std::string& word) { return seconds_up_to(86400, word); }
std::string within_an_age(const std::string& word) { return seconds_up_to(1e9, word); }

void add_time_limit(CLI::App& command, double& seconds,
                    const std::string& what =
                        "CPU seconds that a subject may take for one question; ten times as many "
                        "for one of simulation or constraint") {
  command.add_option("--time-limit", seconds, what)->check(within_a_day)->capture_default_str();
}

void add_run_options(CLI::App& command, RunOptions& options) {
  command.add_option("--subjects", options.subjects,
                     "Who is on trial: names (see `list subjects`), exec:COMMAND LINE, inproc:reference, inproc:fast. "
                     "Default: all that stand beside the program");
  command
      .add_option("--stems", options.stems,
                  "mass, bounds, broad_phase, distance, penetration, pixel, impulse; and time_of_impact, simulation, "
                  "constraint, which are asked when they are named only")
      ->delimiter(',');
  command.add_option("--properties", options.properties, "Ids (see `list properties`). Default: all of the stems")
      ->delimiter(',');
  command
      .add_option("--effort", options.effort,
                  "How many scenes, how long a failing one is cut down. standard: 4,000 a stem; of one subject by "
                  "itself 100,000, but 1,456,000 impacts under the properties that need one answer. Of simulation and "
                  "constraint at most 30 scenes at quick, 1,000 at standard, 10,000 at soak; of simulation by itself "
                  "four times as many from standard on")
      ->check(CLI::IsMember(effort_names()))
      ->capture_default_str();
  command.add_option("--cases", options.cases, "Drawn scenes a stem, instead of the effort's own number")
      ->check(CLI::Range(1, largest_count));
  add_seed(command, options.seed);
  command.add_option("--jobs", options.jobs, "Threads; they change no byte of the result. Default: one a processor")
      ->check(CLI::Range(1, 1024));
  add_time_limit(command, options.time_limit);
  command.add_option("--out", options.out, "Folder of the report")->capture_default_str();
  command.add_option("--json", options.json, "Write report.json to this file too");
  command.add_option("--junit", options.junit, "Write JUnit XML to this file too");
  command.add_option("--meshes", options.meshes,
                     "Folder of STL and OBJ meshes to ask about. Default: report takes those of Debian's dart-doc");
  command.footer(run_footer);
}

void add_report(CLI::App& program, Options& options) {
  options.report.out = "report";
  auto* command = program.add_subcommand("report", "Put engines on trial; write a page, JSON, JUnit XML and the cases");
  add_run_options(*command, options.report);
  command->callback([&options] { options.chosen = [&] { return report(options.report); }; });
}

void add_check(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("check", "The same for CI: terse, and exit code 1 if a property fails");
  add_run_options(*command, options.check);
  command->callback([&options] { options.chosen = [&] { return check(options.check); }; });
}

void add_case_options(CLI::App& command, CaseCommand& options) {
  command.add_option("CASE", options.path, "A case file of a report")->required();
  command.add_option("--subject", options.subject,
                     "Ask this subject (as under check --subjects) instead of the case's");
  add_time_limit(command, options.time_limit);
  command.footer(case_footer);
}

void add_replay(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("replay", "Ask a case again: the clause, the exact truth, the engine's answer");
  add_case_options(*command, options.replay);
  command->add_flag("--json", options.replay.json, "The finding as JSON");
  command->callback([&options] { options.chosen = [&] { return replay(options.replay); }; });
}

void add_minimise(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("minimise", "Cut a failing case down further");
  add_case_options(*command, options.minimise);
  command->add_option("--budget", options.minimise.budget, "Questions that it may take")
      ->check(CLI::Range(1, largest_count))
      ->capture_default_str();
  command->add_option("--out", options.minimise.out, "Where the smaller case goes. Default: CASE with .smaller.json");
  command->callback([&options] { options.chosen = [&] { return minimise(options.minimise); }; });
}

void add_ask(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("ask", "The exact answer about a scene, with its proof");
  command->add_option("QUERY", options.ask.query, listed(queries()))->required()->check(CLI::IsMember(queries()));
  command->add_option("SCENE", options.ask.scene, "A scene file (docs/scene.schema.json)")->required();
  command->add_flag("--json", options.ask.json, "As JSON");
  command->footer(ask_footer);
  command->callback([&options] {
    options.chosen = [&] {
      ask(options.ask.query, options.ask.scene, options.ask.json);
      return 0;
    };
  });
}

void add_plan(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("plan", "What the optimised broad phase does about a scene, what it leaves out, and why");
  command->add_option("SCENE", options.plan.scene, "A scene file (docs/scene.schema.json), or a name of `list motions`")
      ->required();
  command->add_flag("--json", options.plan.json, "As JSON");
  command->footer(plan_footer);
  command->callback([&options] {
    options.chosen = [&] {
      plan(options.plan.scene, options.plan.json);
      return 0;
    };
  });
}

void add_simulate(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("simulate", "What happens next: energies, momentum, impacts, a replay page");
  SimulateCommand& words = options.simulate;
  command->add_option("SCENE", words.scene, "A scene file, or a name of `list motions`")->required();
  command
      ->add_option(
          "--engine", words.engine,
          "fast; constraint (fast's own alternative); reference; bullet, bullet.tuned, ode, ode.quick, simbody "
          "(if they are built); exec:COMMAND LINE; inproc:fast, inproc:reference")
      ->capture_default_str();
  command->add_option("--until", words.until, "Seconds. Default: the end of the scene's flight")->check(within_an_age);
  command->add_option("--out", words.out, "Write the events to this file, a JSON object a line");
  command->add_option("--replay", words.replay, "Write a page that shows the bodies to this file");
  add_time_limit(*command, words.time_limit, "CPU seconds that the engine may take");
  command->footer(simulate_footer);
  command->callback([&options] { options.chosen = [&] { return simulate(options.simulate); }; });
}

void add_import(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("import", "The convex hull of a mesh (OBJ, OFF, STL, PLY) as a scene");
  command->add_option("MESH", options.import.mesh, "A mesh file")->required();
  command->add_option("--out", options.import.out, "The scene file. Default: stdout");
  command->footer(plain_footer);
  command->callback([&options] {
    options.chosen = [&] {
      import_mesh(options.import.mesh, options.import.out);
      return 0;
    };
  });
}

void add_list(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("list", "What there is: " + listed(listable()));
  command->add_option("WHAT", options.list, listed(listable()))->required()->check(CLI::IsMember(listable()));
  command->footer(plain_footer);
  command->callback([&options] {
    options.chosen = [&] {
      list(options.list);
      return 0;
    };
  });
}

void add_soak(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("soak", "The reference against itself: three exact routes over all families of pairs");
  command->add_option("--pairs", options.soak.pairs, "How many, at least")
      ->check(CLI::Range(1, largest_count))
      ->capture_default_str();
  add_seed(*command, options.soak.seed);
  command->add_option("--jobs", options.soak.jobs, "Threads")->check(CLI::Range(1, 1024))->capture_default_str();
  command->footer("\nExit code 3 if two routes disagree: that is our own fault.");
  command->callback(
      [&options] { options.chosen = [&] { return soak(options.soak.pairs, options.soak.seed, options.soak.jobs); }; });
}

void add_bench(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("bench", "Our speed beside that of other libraries: a table, CSV and a plot");
  command->add_option("WHAT", options.bench.name, listed(benches()))->required()->check(CLI::IsMember(benches()));
  command
      ->add_option("--sizes", options.bench.sizes,
                   "broad_phase: bodies; distance: vertices a body; impulse: impacts a class; pixel: pixels a metre; "
                   "simulation: steps a second. "
                   "Default: the comparison's own")
      ->delimiter(',');
  command
      ->add_option("--workloads", options.bench.workloads,
                   "broad_phase: coherent, settled, ratio, clustered, teleport, still; distance: coherent, cold; "
                   "impulse: generic, tiny_slip, friction_to_10, rods, levers, spheres, no_slip; pixel: masks, boxes, "
                   "triangles, 16-gons; simulation: `list motions`. Default: all")
      ->delimiter(',');
  command->add_option("--rounds", options.bench.rounds, "Of which the median is taken")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--out", options.bench.out, "Folder of what is written")->capture_default_str();
  command->footer(bench_footer);
  command->callback([&options] { options.chosen = [&] { return bench(options.bench); }; });
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

/// CLI11 would only say that a subcommand is required.
bool names_no_command(const CLI::App& program, const std::string& word) {
  return !word.starts_with('-') && std::ranges::count(command_names(program), word) == 0;
}

}  // namespace

int run_command(int argc, const char* const* argv) {
  CLI::App program("Touchstone: the reference that collision detection and impact code is tested against.",
                   "touchstone");
  Options options;
  for (const auto add : {add_report, add_check, add_replay, add_minimise, add_ask, add_plan, add_simulate, add_import,
                         add_list, add_soak, add_bench}) {
    add(program, options);
  }
  program.footer(program_footer);
  program.set_version_flag("--version", version);
  program.set_help_all_flag("--help-all", "The help of all commands");
  program.require_subcommand(1);
  if (argc < 2) {
    fmt::print(stderr, "{}", program.help());
    return 2;
  }
  if (names_no_command(program, argv[1])) {
    fmt::print(stderr, "touchstone: no command {}; there are {}\n", argv[1], listed(command_names(program)));
    return 2;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  return options.chosen();
}

}  // namespace touchstone::app
