#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <functional>

#include "app/ask.h"
#include "app/case_commands.h"
#include "app/effort.h"
#include "app/import.h"
#include "app/interruption.h"
#include "app/list.h"
#include "app/report_command.h"
#include "app/soak.h"
#include "app/version.h"
#include "model/input_error.h"

namespace {

using namespace touchstone::app;

constexpr const char* footer = R"(Examples:
  touchstone report --out report                     every engine beside the program, all stems; then open report/index.html
  touchstone check --subjects bullet.double,fcl.libccd --stems distance --junit junit.xml
  touchstone check --subjects "exec:python3 my_engine.py"     your own engine, over JSON lines (docs/protocol.md)
  touchstone replay report/cases/distance.value.bullet.float.json
  touchstone ask distance scene.json                 the exact answer, as a rational, with its proof

Exit codes: 0 done (check: every property holds), 1 check or replay saw a failure, 2 bad input or usage,
3 our own fault, 130 interrupted (the report is written, and says that it is partial).)";

void add_run_options(CLI::App& command, RunOptions& options, const std::string& out_by_default) {
  options.out = out_by_default;
  command
      .add_option("--subjects", options.subjects,
                  "Who is on trial: names (see `list subjects`), exec:COMMAND LINE, inproc:reference, inproc:fast. "
                  "Default: all")
      ->delimiter(',');
  command.add_option("--stems", options.stems, "mass, bounds, broad_phase, distance, penetration. Default: all")
      ->delimiter(',');
  command.add_option("--properties", options.properties, "Ids (see `list properties`). Default: all of the stems")
      ->delimiter(',');
  std::vector<std::string> names;
  for (const Effort& effort : efforts()) names.push_back(effort.name);
  command.add_option("--effort", options.effort, "How many scenes, how long a failing one is cut down")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  command.add_option("--cases", options.cases, "Drawn scenes a stem, instead of the effort's own number")
      ->check(CLI::Range(1, 100'000'000));
  command.add_option("--seed", options.seed, "The same seed gives the same report, byte for byte")
      ->capture_default_str();
  command.add_option("--jobs", options.jobs, "Threads. Default: one a processor")->check(CLI::Range(1, 1024));
  command.add_option("--time-limit", options.time_limit, "CPU seconds that a subject may take for one question")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--out", options.out, "Folder of the report")->capture_default_str();
  command.add_option("--json", options.json, "Write report.json to this file (too)");
  command.add_option("--junit", options.junit, "Write JUnit XML to this file (too)");
  command.add_option("--meshes", options.meshes,
                     "Folder of STL and OBJ meshes. Default: those of Debian's dart-doc, for report");
}

void add_case_options(CLI::App& command, CaseCommand& options) {
  command.add_option("CASE", options.path, "A case file of a report")->required();
  command.add_option("--subject", options.subject, "Ask this subject instead of the case's own");
  command
      .add_option("--time-limit", options.limits.cpu_seconds, "CPU seconds that the subject may take for one question")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

std::string one_of(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

/// Fills `chosen` with what to do.
void define(CLI::App& program, std::function<int()>& chosen) {
  program.footer(footer);
  program.set_version_flag("--version", version);
  program.require_subcommand(1);
  program.set_help_all_flag("--help-all", "The help of all commands");

  static RunOptions report_options;
  auto* report_command =
      program.add_subcommand("report", "Put engines on trial; write a report with the smallest failing scenes");
  add_run_options(*report_command, report_options, "report");
  report_command->callback([&] { chosen = [] { return report(report_options); }; });

  static RunOptions check_options;
  auto* check_command = program.add_subcommand("check", "The same for CI: terse, and exit code 1 if a property fails");
  add_run_options(*check_command, check_options, "");
  check_command->callback([&] { chosen = [] { return check(check_options); }; });

  static CaseCommand replay_options;
  auto* replay_command =
      program.add_subcommand("replay", "Ask a case again: the clause, the exact truth, the engine's answer");
  add_case_options(*replay_command, replay_options);
  replay_command->add_flag("--json", replay_options.json, "The finding as JSON");
  replay_command->callback([&] { chosen = [] { return replay(replay_options); }; });

  static CaseCommand minimise_options;
  auto* minimise_command = program.add_subcommand("minimise", "Cut a failing case down further");
  add_case_options(*minimise_command, minimise_options);
  minimise_command->add_option("--budget", minimise_options.budget, "Questions that it may take")
      ->check(CLI::Range(1, 10'000'000))
      ->capture_default_str();
  minimise_command->add_option("--out", minimise_options.out,
                               "Where the smaller case goes. Default: CASE with .smaller.json");
  minimise_command->callback([&] { chosen = [] { return minimise(minimise_options); }; });

  static std::string query;
  static std::string scene;
  static bool json = false;
  auto* ask_command = program.add_subcommand("ask", "The exact answer about a scene, with its proof");
  ask_command->add_option("QUERY", query, one_of(queries()))->required()->check(CLI::IsMember(queries()));
  ask_command->add_option("SCENE", scene, "A scene file (docs/scene.schema.json)")->required();
  ask_command->add_flag("--json", json, "As JSON");
  ask_command->callback([&] {
    chosen = [] {
      ask(query, scene, json);
      return 0;
    };
  });

  static std::string mesh;
  static std::string out;
  auto* import_command = program.add_subcommand("import", "The convex hull of a mesh (OBJ, OFF, STL, PLY) as a scene");
  import_command->add_option("MESH", mesh, "A mesh file")->required();
  import_command->add_option("--out", out, "The scene file. Default: stdout");
  import_command->callback([&] {
    chosen = [] {
      import_mesh(mesh, out);
      return 0;
    };
  });

  static std::string what;
  auto* list_command = program.add_subcommand("list", "What there is: " + one_of(listable()));
  list_command->add_option("WHAT", what, one_of(listable()))->required()->check(CLI::IsMember(listable()));
  list_command->callback([&] {
    chosen = [] {
      list(what);
      return 0;
    };
  });

  static int pairs = 100'000;
  static std::uint64_t seed = 1;
  static int jobs = 2;
  auto* soak_command =
      program.add_subcommand("soak", "The reference against itself: three exact routes over all families of pairs");
  soak_command->add_option("--pairs", pairs, "How many, at least")
      ->check(CLI::Range(1, 1'000'000'000))
      ->capture_default_str();
  soak_command->add_option("--seed", seed, "Of the draws")->capture_default_str();
  soak_command->add_option("--jobs", jobs, "Threads")->check(CLI::Range(1, 1024))->capture_default_str();
  soak_command->callback([&] { chosen = [] { return soak(pairs, seed, jobs); }; });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Touchstone: the reference that collision detection and impact solvers are tested against.",
                   "touchstone");
  std::function<int()> chosen;
  define(program, chosen);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  try {
    watch_for_interruption();
    return chosen();
  } catch (const touchstone::InputError& error) {
    fmt::print(stderr, "touchstone: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "touchstone: our own fault, please report it with the command and its input: {}\n",
               error.what());
    return 3;
  }
}
