#include "app/commands/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "app/adapter/adapter_command.h"
#include "app/adapter/skeletons.h"
#include "app/commands/ask.h"
#include "app/commands/bench.h"
#include "app/commands/case_commands.h"
#include "app/commands/completion.h"
#include "app/commands/help_texts.h"
#include "app/commands/import.h"
#include "app/commands/judge.h"
#include "app/commands/list.h"
#include "app/commands/option_values.h"
#include "app/commands/plan.h"
#include "app/commands/report_command.h"
#include "app/commands/serve.h"
#include "app/commands/simulate.h"
#include "app/commands/soak.h"
#include "app/fuzz/fuzz_command.h"
#include "app/motion/motion_scenes.h"
#include "app/self_test/self_test.h"
#include "app/system/program_folder.h"
#include "app/system/terminal.h"
#include "app/system/version.h"
#include "app/trend/compare_command.h"
#include "app/trend/summary.h"
#include "app/trial/effort.h"
#include "app/vectors/vectors_command.h"
#include "model/input_error.h"
#include "model/near_names.h"
#include "oracle/process/pipe.h"
#include "oracle/query.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

constexpr int largest_count = 1'000'000'000;

struct AskOptions {
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

struct Summarised {
  std::string report;
  std::vector<std::string> subjects;
};

struct Soaked {
  int pairs = 100'000;
  std::uint64_t seed = 1;
  int jobs = 2;
};

/// The values of the options, one member per command; `chosen` runs the command that was named.
struct Options {
  RunOptions report;
  RunOptions check;
  MergeCommand merge;
  CaseCommand replay;
  CaseCommand minimise;
  AdapterCommand adapter;
  AskOptions ask;
  JudgeOptions judge;
  Planned plan;
  SimulateCommand simulate;
  Imported import;
  std::string list;
  Soaked soak;
  FuzzCommand fuzz;
  CompareOptions compare;
  VectorsCommand vectors;
  SelfTestCommand self_test;
  Summarised summary;
  BenchOptions bench;
  std::string help;        ///< a command; empty: all
  std::string completion;  ///< a shell
  std::function<int()> chosen;
};

constexpr const char* scene_help =
    "A scene: a file (docs/scene.schema.json), - for stdin, or a name of `touchstone list motions`";

std::string listed(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::vector<std::string> effort_names() {
  std::vector<std::string> names;
  for (const Effort& effort : efforts()) names.push_back(effort.name);
  return names;
}

void add_seed(CLI::App& command, std::uint64_t& seed) {
  add_whole_number(command, "--seed", seed, std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max(),
                   "Chooses the scenes, 0 to 2^64-1; the same seed gives the same result, byte for byte")
      ->default_str(std::to_string(seed));
}

CLI::Option* add_jobs(CLI::App& command, int& jobs, const std::string& description) {
  return add_whole_number(command, "--jobs", jobs, 1, 1024, description);
}

void add_time_limit(CLI::App& command, double& seconds, const std::string& description) {
  command.add_option("--time-limit", seconds, description)
      ->check(seconds_up_to(86400))
      ->type_name("SECONDS")
      ->capture_default_str();
}

void add_limit_of_a_question(CLI::App& command, double& seconds) {
  add_time_limit(command, seconds,
                 "CPU time that a subject may take for one question; it may take ten times as long for one of "
                 "simulation or constraint, in a run with effort quick five times");
}

CLI::Option* add_file(CLI::App& command, const std::string& option, std::string& file, const std::string& description) {
  return command.add_option(option, file, description)->type_name("FILE");
}

CLI::Option* add_folder(CLI::App& command, const std::string& option, std::string& folder,
                        const std::string& description) {
  return command.add_option(option, folder, description)->type_name("FOLDER");
}

/// The help shows a positional argument only by its name.
CLI::Option* add_argument(CLI::App& command, const std::string& name, std::string& word,
                          const std::string& description) {
  return command.add_option(name, word, description)->type_name("");
}

void add_subjects(CLI::App& command, std::vector<std::string>& subjects) {
  command
      .add_option("--subjects", subjects,
                  "What to test: names of `touchstone list subjects`, \"exec:COMMAND LINE\" for a program of your own, "
                  "inproc:reference, inproc:fast, inproc:fast.warm. Default: all subjects that were built")
      ->type_name("SUBJECT");
}

void add_run_options(CLI::App& command, RunOptions& options) {
  add_subjects(command, options.subjects);
  command
      .add_option("--queries", options.queries,
                  fmt::format("The queries to ask. Default: all of {}", listed(properties::tested_queries())))
      ->delimiter(',')
      ->type_name("QUERIES");
  command
      .add_option("--properties", options.properties,
                  "The properties to test: ids of `touchstone list properties`. Default: all of these queries")
      ->delimiter(',')
      ->type_name("PROPERTY");
  command
      .add_option(
          "--effort", options.effort,
          "quick, standard or soak: how many scenes are asked, and how long a failing one is made smaller. "
          "quick asks several subjects about 300 scenes of each query, and one by itself about 4,000; "
          "standard asks several subjects about 1,000 scenes of each query, and one by itself about 100,000 "
          "and about 1,456,000 impacts for the properties that need one answer each. Trajectories are longer: "
          "of simulation, quick asks for at most 68 drawn scenes (960 of one subject by itself) and 20 extreme ones, "
          "standard for 100 (4,000) and soak for 10,000 (40,000); of constraint 120, 400 and 10,000 (beside others "
          "half of that, and of the extreme scenes). Beside other subjects one that computes exactly is asked about "
          "400 scenes of each query (soak: 4,000), and "
          "for no trajectory of these two queries")
      ->check(one_of(effort_names()))
      ->type_name("EFFORT")
      ->capture_default_str();
  add_whole_number(command, "--cases", options.cases, 1, largest_count,
                   "How many scenes of each query to draw, instead of the effort's own number");
  add_seed(command, options.seed);
  add_jobs(command, options.jobs,
           "How many threads; the result does not depend on it. Default: one for each processor");
  add_limit_of_a_question(command, options.time_limit);
  CLI::Option* out = add_folder(command, "--out", options.files.out, "Write the report to this folder");
  if (!options.files.out.empty()) out->capture_default_str();
  add_file(command, "--json", options.files.json, "Write report.json to this file too");
  add_file(command, "--junit", options.files.junit, "Write JUnit XML to this file too");
  add_file(command, "--sarif", options.files.sarif, "Write SARIF 2.1.0, for code scanning, to this file too");
  add_folder(command, "--meshes", options.meshes,
             "Ask about the STL and OBJ meshes in this folder. Default: report takes those of Debian's dart-doc, check "
             "takes none");
  command.add_flag("--skip-self-test", options.skip.self_test,
                   "Judge before anything has shown that this build's own answers are right (touchstone self-test)");
  command.add_flag("--skip-adapter-check", options.skip.adapter_check,
                   "Judge a subject exec:... also if its adapter fails the scenes of adapter check, which are asked "
                   "first");
}

void add_report(CLI::App& program, Options& options) {
  options.report.files.out = "report";
  auto* command =
      program.add_subcommand("report", "Test engines; write a page, JSON, JUnit XML and a case for each failure");
  add_run_options(*command, options.report);
  command
      ->add_option("--shard", options.report.files.shard,
                   "Ask only this part of the scenes, as 3/8, and write it to FOLDER/shard-3-of-8.jsonl; `touchstone "
                   "merge` makes the report of all parts")
      ->type_name("NUMBER/OF")
      ->excludes("--json")
      ->excludes("--junit")
      ->excludes("--sarif");
  command->footer(help::report);
  command->callback([&options] { options.chosen = [&] { return report(options.report); }; });
}

void add_merge(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("merge", "Make one report of the shards that report --shard has written");
  MergeCommand& words = options.merge;
  words.files.out = "report";
  add_argument(*command, "SHARDS", words.folder, "The folder with the shards")->required();
  add_jobs(*command, words.jobs, "How many threads make failing scenes smaller. Default: one for each processor");
  add_folder(*command, "--out", words.files.out, "Write the report to this folder")->capture_default_str();
  add_file(*command, "--json", words.files.json, "Write report.json to this file too");
  add_file(*command, "--junit", words.files.junit, "Write JUnit XML to this file too");
  add_file(*command, "--sarif", words.files.sarif, "Write SARIF 2.1.0, for code scanning, to this file too");
  command->footer(help::merge);
  command->callback([&options] { options.chosen = [&] { return merge(options.merge); }; });
}

void add_check(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("check", "The same for CI: short output, and exit code 1 if a property fails");
  add_run_options(*command, options.check);
  CLI::Option* first =
      command->add_flag("--first-failure", options.check.pass.first_failure,
                        "Stop at the first scene on which a property fails, and do not make it smaller");
  CLI::Option* baseline =
      add_file(*command, "--baseline", options.check.pass.baseline,
               "Accept the failures that this file has: exit code 1 only if one is new, worse or no longer waived, or "
               "does not occur any more")
          ->excludes(first);
  add_file(*command, "--write-baseline", options.check.pass.write_baseline,
           "Write the failures of this run to this file, and keep its waivers; they are then no reason for exit code 1")
      ->excludes(first);
  command
      ->add_option("--today", options.check.pass.today,
                   "The date with which the baseline's waivers are compared. Default: the date in UTC")
      ->type_name("DATE")
      ->needs(baseline);
  command->add_flag("--require-answers", options.check.pass.require_answers,
                    "Exit code 1 also if a subject answers none of the scenes of a query that is asked");
  command->footer(help::check);
  command->callback([&options] { options.chosen = [&] { return check(options.check); }; });
}

void add_case_options(CLI::App& command, CaseCommand& options) {
  add_argument(command, "CASE", options.path, "A case file of a report, or - for stdin")->required();
  command
      .add_option("--subject", options.subject,
                  "Ask this subject instead of the case's own; as under --subjects of `touchstone help check`")
      ->type_name("SUBJECT");
  add_limit_of_a_question(command, options.time_limit);
}

void add_replay(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("replay", "Ask a case again: the clause, the exact truth and the engine's answer");
  add_case_options(*command, options.replay);
  CLI::Option* json = command->add_flag("--json", options.replay.json, "Print the finding as JSON");
  command
      ->add_flag("--trace", options.replay.trace, "First print the lines of the protocol: > to the subject, < from it")
      ->excludes(json);
  command->footer(help::replay);
  command->callback([&options] { options.chosen = [&] { return replay(options.replay); }; });
}

void add_minimise(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("minimise", "Make a failing case smaller");
  add_case_options(*command, options.minimise);
  add_whole_number(*command, "--budget", options.minimise.budget, 1, largest_count,
                   "How many times the subject may be asked")
      ->default_str(std::to_string(options.minimise.budget));
  add_file(
      *command, "--out", options.minimise.out,
      "Write the smaller case to this file. Default: CASE with the ending .smaller.json; smaller.json if CASE is -");
  command->footer(help::minimise);
  command->callback([&options] { options.chosen = [&] { return minimise(options.minimise); }; });
}

void add_adapter(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("adapter", "Write the skeleton of an adapter, check it, or measure its engine's domain");
  AdapterCommand& words = options.adapter;
  add_argument(*command, "ACTION", words.action, listed(adapter_actions()))
      ->required()
      ->check(one_of(adapter_actions()));
  add_argument(*command, "NAME", words.name,
               "new: the adapter's name, also of its folder (default: my_engine). check, domain: what to ask, as under "
               "--subjects of `touchstone help check`");
  auto* language = command->add_option("--lang", words.language, "new: the language, " + listed(adapter_languages()));
  language->check(one_of(adapter_languages()))->type_name("LANGUAGE");
  auto* queries =
      command->add_option("--queries", words.queries, "check, domain: these only. Default: all that it answers");
  queries->delimiter(',')->check(one_of(oracle::query_names()))->type_name("QUERIES");
  auto* json = command->add_flag("--json", words.json, "check, domain: print JSON");
  language->excludes(queries)->excludes(json);
  add_limit_of_a_question(*command, words.time_limit);
  command->footer(help::adapter);
  command->callback([&options] { options.chosen = [&] { return adapter(options.adapter); }; });
}

void add_ask(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("ask", "Print the exact answer to a query about a scene, with its proof");
  add_argument(*command, "QUERY", options.ask.query, listed(printed_queries()))
      ->required()
      ->check(one_of(printed_queries()));
  add_argument(*command, "SCENE", options.ask.scene, scene_help)->required();
  command->add_flag("--json", options.ask.json, "Print JSON");
  command->footer(help::ask);
  command->callback([&options] {
    options.chosen = [&] {
      ask(options.ask.query, options.ask.scene, options.ask.json);
      return 0;
    };
  });
}

void add_serve(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("serve", "Answer exact queries of another program, over JSON lines");
  command->footer(help::serve);
  command->callback([&options] { options.chosen = serve; });
}

void add_judge(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("judge", "Judge subjects on a scene of your own, by each property that applies");
  JudgeOptions& words = options.judge;
  add_argument(*command, "SCENE", words.scene, scene_help)->required();
  add_subjects(*command, words.subjects);
  command->add_option("--queries", words.queries, "The queries to ask. Default: all that the scene has the parts for")
      ->delimiter(',')
      ->type_name("QUERIES");
  command->add_flag("--json", words.json, "Print JSON");
  add_limit_of_a_question(*command, words.time_limit);
  command->footer(help::judge);
  command->callback([&options] { options.chosen = [&] { return judge(options.judge); }; });
}

void add_plan(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand(
      "plan", "Print which parts of the optimised broad phase a scene needs, which it leaves out, and why");
  add_argument(*command, "SCENE", options.plan.scene, scene_help)->required();
  command->add_flag("--json", options.plan.json, "Print JSON");
  command->footer(help::plan);
  command->callback([&options] {
    options.chosen = [&] {
      plan(options.plan.scene, options.plan.json);
      return 0;
    };
  });
}

void add_simulate(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("simulate", "Follow a scene in time: energies, momentum, impacts, a page that shows it");
  SimulateCommand& words = options.simulate;
  add_argument(*command, "SCENE", words.scene, scene_help)->required();
  command
      ->add_option("--engine", words.engine,
                   "fast; constraint (fast's own alternative); reference; bullet, bullet.tuned, ode, ode.quick, "
                   "simbody (if they "
                   "are built); \"exec:COMMAND LINE\"; inproc:fast, inproc:reference")
      ->type_name("ENGINE")
      ->capture_default_str();
  command->add_option("--until", words.until, "When to end. Default: the end of the scene's motion")
      ->check(seconds_up_to(1e9))
      ->type_name("SECONDS");
  add_file(*command, "--out", words.out, "Write the events to this file, one JSON object a line");
  add_file(*command, "--replay", words.replay, "Write a page that shows the bodies to this file");
  command
      ->add_option("--beside", words.beside,
                   "Engines, at most five, that the page shows beside --engine, from the same start: names as there")
      ->allow_extra_args(false)
      ->type_name("ENGINE");
  add_time_limit(*command, words.time_limit, "CPU time that the engine may take");
  command->footer(help::simulate);
  command->callback([&options] { options.chosen = [&] { return simulate(options.simulate); }; });
}

void add_import(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("import", "Turn the convex hull of a mesh (OBJ, OFF, STL, PLY) into a scene");
  add_argument(*command, "MESH", options.import.mesh,
               "A mesh file, or - for stdin, in a format that is recognised by its content")
      ->required();
  add_file(*command, "--out", options.import.out, "Write the scene to this file. Default: stdout");
  command->footer(help::import);
  command->callback([&options] {
    options.chosen = [&] {
      import_mesh(options.import.mesh, options.import.out);
      return 0;
    };
  });
}

void add_list(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("list", "Print what there is: " + listed(listable()));
  add_argument(*command, "LIST", options.list, listed(listable()))->required()->check(one_of(listable()));
  command->footer(help::list);
  command->callback([&options] {
    options.chosen = [&] {
      list(options.list);
      return 0;
    };
  });
}

void add_soak(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand(
      "soak", "Compare the reference with itself: distances of many pairs, by three exact algorithms");
  add_whole_number(*command, "--pairs", options.soak.pairs, 1, largest_count, "How many pairs, at least")
      ->default_str(std::to_string(options.soak.pairs));
  add_seed(*command, options.soak.seed);
  add_jobs(*command, options.soak.jobs, "How many threads")->default_str(std::to_string(options.soak.jobs));
  command->footer(help::soak);
  command->callback(
      [&options] { options.chosen = [&] { return soak(options.soak.pairs, options.soak.seed, options.soak.jobs); }; });
}

void add_fuzz(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("fuzz", "Look for failures on mutated scenes, guided by coverage and by how near one is");
  FuzzCommand& words = options.fuzz;
  add_argument(*command, "QUERY", words.query, listed(properties::tested_queries()))
      ->required()
      ->check(one_of(properties::tested_queries()));
  command
      ->add_option("--subject", words.subject,
                   "What to test, as under --subjects of `touchstone help check`. Default: inproc:fast, which alone "
                   "shows its coverage; inproc:reference for a query that fast does not answer")
      ->type_name("SUBJECT");
  command
      ->add_option("--properties", words.properties,
                   "The properties to test: ids of `touchstone list properties`. Default: all of this query")
      ->delimiter(',')
      ->type_name("PROPERTY");
  command->add_option("--time", words.time, "End after so much time. Default: 60, unless --executions is given")
      ->check(seconds_up_to(1e6))
      ->type_name("SECONDS");
  command
      ->add_option_function<std::string>(
          "--executions",
          [&words](const std::string& word) {
            words.executions = whole_number("--executions", word, 1, largest_count);
          },
          "End after so many scenes; then the result does not depend on the machine")
      ->type_name("NUMBER");
  command
      ->add_option_function<std::string>(
          "--enlarge",
          [&words](const std::string& word) {
            words.enlarge = static_cast<int>(whole_number("--enlarge", word, 3, largest_count));
          },
          "Afterwards make the largest error of each finding larger: a search over the numbers of its scene (NLopt's "
          "Subplex) asks so many questions. The scene is written beside the smallest one, as NAME.largest.json")
      ->type_name("QUESTIONS");
  command->add_flag("--first-failure", words.first_failure, "End with the first finding, and do not make it smaller");
  command->add_flag("--empty-corpus", words.empty_corpus,
                    "Begin with a single scene, instead of draws of all families and known cases");
  add_seed(*command, words.seed);
  add_limit_of_a_question(*command, words.time_limit);
  add_folder(*command, "--out", words.out, "Write a case file for each finding to this folder")->capture_default_str();
  command->add_flag("--json", words.json, "Print JSON");
  command->add_flag(
      "--skip-adapter-check", words.skip_adapter_check,
      "Also fuzz a subject exec:... whose adapter fails the scenes of adapter check, which are asked first");
  command->footer(help::fuzz);
  command->callback([&options] { options.chosen = [&] { return fuzz(options.fuzz); }; });
}

void add_self_test(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("self-test", "Does this build answer the published test vectors as they were published?");
  SelfTestCommand& words = options.self_test;
  command->add_option("--queries", words.queries, "The queries to ask. Default: all")
      ->delimiter(',')
      ->check(one_of(properties::tested_queries()))
      ->type_name("QUERIES");
  add_jobs(*command, words.jobs, "How many threads. Default: one for each processor");
  command->footer(help::self_test);
  command->callback([&options] { options.chosen = [&] { return self_test(options.self_test); }; });
}

void add_vectors(CLI::App& program, Options& options) {
  auto* command =
      program.add_subcommand("vectors", "Write test vectors: scenes with their exact answers, for any test");
  VectorsCommand& words = options.vectors;
  add_argument(*command, "FOLDER", words.folder, "The folder with a file for each query")->capture_default_str();
  command->add_option("--queries", words.queries, "The files to write. Default: all that have test vectors")
      ->delimiter(',')
      ->type_name("QUERY")
      ->check(one_of(properties::tested_queries()));
  command->add_option("--add", words.cases, "Also the scenes of these case files")->type_name("CASE");
  add_whole_number(*command, "--draw", words.draws, 0, 1000, "Also so many scenes of each family, the shortest first")
      ->default_str("0");
  add_seed(*command, words.seed);
  add_file(*command, "--page", words.page, "Also write a page that shows all of them");
  command->add_flag("--check", words.check, "Write nothing; say which files differ from what would be written");
  command->footer(help::vectors);
  command->callback([&options] { options.chosen = [&] { return vectors(options.vectors); }; });
}

void add_compare(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand(
      "compare", "What changed between two reports: two versions of an engine, or two of its settings");
  CompareOptions& words = options.compare;
  add_argument(*command, "OLD", words.before, "A report.json")->required();
  add_argument(*command, "NEW", words.after, "Another one; or the same, with --subjects OLD=NEW")->required();
  command
      ->add_option(
          "--subjects", words.subjects,
          "The subjects to compare: a name, or OLD=NEW if it has another one now. Default: all that are in both")
      ->delimiter(',')
      ->type_name("SUBJECT");
  command->add_flag("--json", words.json, "Print JSON");
  command->footer(help::compare);
  command->callback([&options] { options.chosen = [&] { return compare_reports(options.compare); }; });
}

void add_summary(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("summary", "Print a report as a table in Markdown");
  add_argument(*command, "REPORT", options.summary.report, "A report.json, or - for stdin")->required();
  command->add_option("--subjects", options.summary.subjects, "The rows. Default: all subjects that answer anything")
      ->delimiter(',')
      ->type_name("SUBJECT");
  command->footer(help::summary);
  command->callback([&options] {
    options.chosen = [&] {
      summarise(options.summary.report, options.summary.subjects);
      return 0;
    };
  });
}

void add_bench(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand(
      "bench", "Compare our speed with that of other libraries (use the launcher: ./touchstone bench)");
  add_argument(*command, "COMPARISON", options.bench.name, listed(benches()))->required()->check(one_of(benches()));
  command
      ->add_option(
          "--sizes", options.bench.sizes,
          "broad_phase: bodies; distance: vertices of a body; first_call: scenes of a row; impulse: impacts of "
          "a class; pixel: pixels for a metre; simulation: steps for a second; time_of_impact: vertices of a body. "
          "Default: the comparison's own")
      ->delimiter(',')
      ->type_name("NUMBER");
  command
      ->add_option(
          "--workloads", options.bench.workloads,
          "broad_phase: coherent, settled, flickering, ratio, clustered, teleport, still, announced; distance: "
          "coherent, cold, each also _100 and _1000, once, once_overlapping, once_touching; first_call: the queries; "
          "impulse: generic, tiny_slip, friction_to_10, rods, levers, spheres, no_slip; pixel: masks, boxes, "
          "triangles, 16-gons; simulation: names of `touchstone list motions`; time_of_impact: screws, tumbling, each "
          "also _1 and _once. Default: all")
      ->delimiter(',')
      ->type_name("WORKLOAD");
  add_whole_number(*command, "--rounds", options.bench.rounds, 1, 1000, "How many times; the median is printed")
      ->default_str(std::to_string(options.bench.rounds));
  add_folder(*command, "--out", options.bench.out, "Write the files to this folder")->capture_default_str();
  command->footer(help::bench);
  command->callback([&options] { options.chosen = [&] { return bench(options.bench); }; });
}

/// A command of the launcher. Someone who asks the program instead deserves a better message than "unknown command".
void add_for_launcher(CLI::App& program, Options& options, const std::string& name, const std::string& description,
                      const char* footer, const std::string& what_is_missing) {
  auto* command = program.add_subcommand(name, description + " (use the launcher: ./touchstone " + name + ")");
  command->prefix_command();
  command->footer(footer);
  command->callback([&options, name, what_is_missing] {
    options.chosen = [name, what_is_missing]() -> int {
      throw InputError(name, "this program has no " + what_is_missing +
                                 " in it; the launcher at the root of the source tree does this: ./touchstone " + name +
                                 " (see `touchstone help " + name + "`)");
    };
  });
}

void add_test(CLI::App& program, Options& options) {
  add_for_launcher(program, options, "test", "Build and run the test suite", help::test, "tests");
}

void add_package(CLI::App& program, Options& options) {
  add_for_launcher(program, options, "package", "Make a .deb and a tarball of the program", help::package, "source");
}

void add_mutate(CLI::App& program, Options& options) {
  add_for_launcher(program, options, "mutate", "Plant faults in the source: which are found?", help::mutate, "source");
}

void add_engines(CLI::App& program, Options& options) {
  add_for_launcher(program, options, "engines", "Install engines of npm, to be judged", help::engines, "adapters");
}

std::string not_empty(const std::string& word) { return word.empty() ? "is empty" : ""; }

/// An empty word is usually a script's variable that is not set. Options with numbers say what they expect instead.
void refuse_empty_words(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    for (CLI::Option* option : command->get_options()) {
      const std::string type = option->get_type_name();
      const bool is_number = type == "NUMBER" || type == "SECONDS";
      if (option->get_items_expected_max() > 0 && !is_number) option->check(not_empty);
    }
  }
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

void add_help(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("help", "Print the help of a command");
  add_argument(*command, "COMMAND", options.help, "Default: what all commands are for")
      ->check([&program](const std::string& word) { return one_of(command_names(program))(word); });
  command->footer(help::help);
  command->callback([&program, &options] {
    options.chosen = [&] {
      // program.help() would be the help of this command, which has been chosen
      print_lines(options.help.empty()
                      ? program.get_formatter()->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal)
                      : program.get_subcommand(options.help)->help(program.get_name()));
      return 0;
    };
  });
}

ValueWords words_of_values(const CLI::App& program) {
  std::vector<std::string> properties, motions;
  for (const properties::Property& property : properties::all()) properties.push_back(property.id);
  for (const MotionScene& motion : motion_scenes()) motions.push_back(motion.scene.name);
  return {{"ACTION", adapter_actions()},
          {"COMMAND", command_names(program)},
          {"COMPARISON", benches()},
          {"EFFORT", effort_names()},
          {"ENGINE", engine_names()},
          {"LANGUAGE", adapter_languages()},
          {"LIST", listable()},
          {"PROPERTY", properties},
          {"QUERIES", properties::tested_queries()},
          {"QUERY", printed_queries()},
          {"SCENE", motions},
          {"SHELL", completion_shells()},
          {"SUBJECT", oracle::subjects_beside(subjects_folder())}};
}

void add_completion(CLI::App& program, Options& options) {
  auto* command = program.add_subcommand("completion", "Print a script that completes commands and options in a shell");
  add_argument(*command, "SHELL", options.completion, listed(completion_shells()))
      ->required()
      ->check(one_of(completion_shells()));
  command->footer(help::completion);
  command->callback([&program, &options] {
    options.chosen = [&] {
      print_lines(completion_script(program, words_of_values(program), options.completion));
      return 0;
    };
  });
}

/// Breaks a text between words. The help indents the lines that follow.
std::string wrapped(const std::string& text) {
  constexpr std::size_t width = 86;  // 120 columns minus CLI11's own 30, and a margin
  std::istringstream words(text);
  std::string lines, word;
  std::size_t column = 0;
  while (words >> word) {
    const bool fits = column + 1 + word.size() <= width;
    if (column > 0) lines += fits ? ' ' : '\n';
    column = column > 0 && fits ? column + 1 + word.size() : word.size();
    lines += word;
  }
  return lines;
}

void wrap_descriptions(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    command->get_help_ptr()->description("Print this help");
    for (CLI::Option* option : command->get_options()) option->description(wrapped(option->get_description()));
  }
}

std::string see_help(const std::string& command) {
  return fmt::format("; see `touchstone help{}{}`", command.empty() ? "" : " ", command);
}

/// CLI11 first reports what is missing, but the reason may be a misspelt option.
InputError usage_error(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const CLI::App& command = chosen.empty() ? program : *chosen.front();
  const std::string help = see_help(chosen.empty() ? "" : command.get_name());
  for (const std::string& word : command.remaining()) {
    const std::string option = word.substr(0, word.find('='));
    if (option == "--stems") return {option, "is --queries now" + help};
    if (option.starts_with('-')) return {option, unknown_among(option, option_names(command)) + help};
  }
  return {"", error.what() + help};
}

}  // namespace

int run_command(int argc, const char* const* argv) {
  CLI::App program("Touchstone: the reference that collision detection and impact code is tested against.",
                   "touchstone");
  Options options;
  for (const auto add : {add_report,  add_merge,     add_check,   add_replay,     add_minimise, add_adapter, add_ask,
                         add_serve,   add_judge,     add_plan,    add_simulate,   add_import,   add_list,    add_soak,
                         add_fuzz,    add_self_test, add_vectors, add_compare,    add_summary,  add_bench,   add_test,
                         add_package, add_mutate,    add_engines, add_completion, add_help}) {
    add(program, options);
  }
  refuse_empty_words(program);
  wrap_descriptions(program);
  program.footer(help::program);
  program.get_help_ptr()->description("Print this help");
  program.set_version_flag("--version", version, "Print the version");
  program.set_help_all_flag("--help-all", "Print the help of all commands");
  program.require_subcommand(1);
  if (argc < 2) {
    complain("a command is missing; see `touchstone help`");
    print_error_lines("\n" + program.help());
    return 2;
  }
  const std::string first = argv[1];
  const std::vector<std::string> commands = command_names(program);
  if (!first.starts_with('-') && std::ranges::count(commands, first) == 0) {  // CLI11 would say: a command is missing
    throw InputError("command \"" + first + '"', unknown_among(first, commands) + see_help(""));
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw usage_error(program, error);
    std::ostringstream help;
    program.exit(error, help, help);
    print_lines(help.str());
    return 0;
  }
  return options.chosen();
}

}  // namespace touchstone::app
