#include "app/commands/report_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "app/adapter/proven.h"
#include "app/baseline/comparison.h"
#include "app/report/atlas_csv.h"
#include "app/report/finding_words.h"
#include "app/report/page/report_html.h"
#include "app/report/replay_command.h"
#include "app/report/report_json.h"
#include "app/report/report_junit.h"
#include "app/report/report_sarif.h"
#include "app/report/timing_json.h"
#include "app/self_test/self_test.h"
#include "app/system/interruption.h"
#include "app/system/terminal.h"
#include "app/system/writable.h"
#include "app/trial/causes.h"
#include "app/trial/parallel.h"
#include "app/trial/questions.h"
#include "app/trial/subject_list.h"
#include "app/trial/trial.h"
#include "app/trial/unanswered.h"
#include "app/units/shard_file.h"
#include "model/input_error.h"
#include "model/json.h"
#include "model/near_names.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> chosen_properties(const RunOptions& options) {
  const std::vector<std::string>& known = properties::tested_queries();
  for (const std::string& query : options.queries) {
    if (std::ranges::count(known, query) == 0) throw InputError("query " + query, unknown_among(query, known));
  }
  for (const std::string& id : options.properties) properties::find(id);
  std::vector<std::string> chosen;
  for (const properties::Property& property : properties::all()) {
    const bool of_queries = options.queries.empty() || std::ranges::count(options.queries, property.query) > 0;
    const bool named = options.properties.empty() || std::ranges::count(options.properties, property.id) > 0;
    if (of_queries && named) chosen.push_back(property.id);
  }
  if (chosen.empty()) throw InputError("--properties", "none of them is of the queries that --queries names");
  return chosen;
}

Effort chosen_effort(const RunOptions& options, std::size_t subjects) {
  Effort effort = *std::ranges::find(efforts(), options.effort, &Effort::name);
  if (options.cases > 0) {
    effort.extreme_cases = std::max(1, effort.extreme_cases * options.cases / effort.cases);
    effort.cases = effort.trajectories.simulations = effort.trajectories.constraints = options.cases;
    effort.more_impacts = 0;
  } else if (subjects == 1) {
    effort.cases = effort.cases_alone;
    effort.trajectories.simulations = effort.trajectories.simulations_alone;
  } else {
    effort.more_impacts = 0;
    effort.extreme_cases /= fewer_beside_others;
    effort.trajectories.extreme_cases /= fewer_beside_others;
    effort.trajectories.constraints /= fewer_beside_others;
    effort.mesh_pairs = mesh_pairs_beside_others;
  }
  return effort;
}

TrialPlan plan_of(const RunOptions& options) {
  TrialPlan plan;
  plan.properties = chosen_properties(options);
  plan.subjects = subject_list(options.subjects);
  plan.effort = chosen_effort(options, plan.subjects.size());
  plan.seed = options.seed;
  plan.jobs = threads_of(options.jobs);
  plan.limits = limits_of(options.time_limit, plan.effort.trajectories.time_factor);
  plan.first_failure = options.pass.first_failure;
  plan.profiled = !options.files.out.empty();
  return plan;
}

std::vector<std::string> asked_queries(const TrialPlan& plan) {
  std::set<std::string> queries;
  for (const std::string& id : plan.properties) queries.insert(properties::find(id).query);
  return {queries.begin(), queries.end()};
}

/// Not when interrupted: the run then ends at once.
void prove_adapters(const RunOptions& options, const TrialPlan& plan) {
  if (!options.skip.adapter_check) require_proven_adapters(plan.subjects, asked_queries(plan), plan.limits);
}

/// The self-test takes seconds, so what is bad input is refused before it: an unknown subject here, the rest by now.
void prove_judge(const RunOptions& options, const TrialPlan& plan) {
  if (options.skip.self_test) return;
  for (const std::string& subject : plan.subjects) connect(subject, plan.limits);
  require_published_answers(asked_queries(plan), plan.jobs);
}

MeshSet meshes_of(const RunOptions& options) { return read_meshes(options.meshes, options.effort == "quick"); }

/// Checks the places before a run of minutes, not after it. A shard has no cases.
void prepare_places(const RunOptions& options) {
  if (!options.files.out.empty()) {
    const fs::path cases =
        options.files.shard.empty() ? fs::path(options.files.out) / "cases" : fs::path(options.files.out);
    std::error_code error;
    fs::create_directories(cases, error);
    if (error) throw InputError(options.files.out, error.message());
    require_writable_folder(cases, options.files.out);
    require_writable_folder(options.files.out, options.files.out);
  }
  for (const std::string& file :
       {options.files.json, options.files.junit, options.files.sarif, options.pass.write_baseline}) {
    if (!file.empty()) require_writable_file(file);
  }
}

/// Matches only the files that a report writes: a folder named cases may contain other files.
bool is_case_of_a_report(const fs::path& file) {
  const std::string name = file.filename().string();
  return file.extension() == ".json" &&
         std::ranges::any_of(properties::all(),
                             [&](const properties::Property& property) { return name.starts_with(property.id + "."); });
}

/// Names the cases' commands before the page and the JUnit XML print them.
void name_replay_commands(Ledger& ledger, const TrialPlan& plan, const fs::path& folder) {
  const auto name = [&](Row& row) {
    if (!row.minimised.result) return;
    std::optional<double> limit;
    if (row.minimised.result->finding.defect == oracle::Defect::hung) {
      const bool is_patient = !is_simulated(row.property->query);  // replay's factor is always the patient one
      limit = plan.limits.cpu_seconds * (is_patient ? 1 : plan.limits.simulation_factor / patient_simulation_factor);
    }
    row.minimised.replay_command =
        replay_command((folder / row.minimised.case_file).string(), row.minimised.result->subject, limit);
  };
  for (ResultMatrix* results : {&ledger.results, &ledger.beyond}) std::ranges::for_each(results->all(), name);
}

/// Removes the old report first and writes index.html last: if index.html exists, the report is complete.
void write_report(const fs::path& folder, const Ledger& ledger) {
  for (const char* file : {"index.html", "report.json", "report.timing.json", "atlas.csv", "junit.xml"}) {
    fs::remove(folder / file);
  }
  for (const fs::directory_entry& old : fs::directory_iterator(folder / "cases")) {
    if (is_case_of_a_report(old.path())) fs::remove(old.path());
  }
  for (const ResultMatrix* results : {&ledger.results, &ledger.beyond}) {
    for (const Row& row : results->all()) {
      if (row.minimised.result) oracle::write_case(*row.minimised.result, (folder / row.minimised.case_file).string());
    }
  }
  write_text((folder / "report.json").string(), text_of(report_json(ledger)));
  write_text((folder / "report.timing.json").string(), text_of(timing_json(ledger)));
  write_text((folder / "atlas.csv").string(), atlas_csv(ledger));
  write_text((folder / "junit.xml").string(), report_junit(ledger));
  write_text((folder / "index.html").string(), report_html(ledger));
}

void write_extras(const RunOptions& options, const Ledger& ledger) {
  if (!options.files.json.empty()) write_text(options.files.json, text_of(report_json(ledger)));
  if (!options.files.junit.empty()) write_text(options.files.junit, report_junit(ledger));
  if (!options.files.sarif.empty()) write_text(options.files.sarif, text_of(report_sarif(ledger, options.files.out)));
}

long failing_rows(const Ledger& ledger) { return std::ranges::count_if(ledger.results.all(), &Row::failing); }

/// "bullet.double distance.value"
std::string name_of(const Row& row) { return row.subject->card.name + ' ' + row.property->id; }

std::string verdict_on(const Row& row) {
  return fmt::format("{}: {}, grade {}", name_of(row), share_of(row), oracle::name_of(*row.grade()));
}

/// Of a cause, the words once, and then only the names of the other rows that it breaks. Rows that fail as a baseline
/// says are left out.
void print_failing(const Ledger& ledger) {
  for (Cause& cause : causes(ledger)) {
    std::erase_if(cause.rows, [](const Row* row) { return !row->baseline.known.empty(); });
    if (cause.rows.empty()) continue;
    const Row& first = *cause.rows.front();
    print("{}\n", verdict_on(first));
    for (const auto& [label, words] : lines_of(shown_finding(first))) print("    {:<9} {}\n", label, words);
    if (first.minimised.result && first.minimised.result->changed) {
      print("    {:<9} {}\n", "asked of", first.minimised.result->changed->how);
    }
    if (!first.minimised.replay_command.empty()) print("    {}\n", first.minimised.replay_command);
    for (const Row* row : cause.rows) {
      if (row != &first) print("{}, for the same cause\n", verdict_on(*row));
    }
  }
}

constexpr std::size_t longest_case = 8192;  // characters of a case that is printed

/// Ranks rows that compare with the truth first: conservation properties have bounds of their own.
std::pair<bool, double> closeness(const Row& row) {
  if (!row.examples.closest) return {false, -1};
  return {compares_with_truth(*row.property),
          row.examples.closest->finding.error / row.examples.closest->finding.allowed};
}

/// Prints, for each query, the correct answer with the largest error relative to the allowed error. Writes or prints
/// its case.
void print_closest(const Ledger& ledger, const std::string& out) {
  for (const auto& [query, scenes] : ledger.scenes) {
    const Row* found = nullptr;
    for (const Row& row : ledger.results.all()) {
      if (row.property->query != query) continue;
      if (!found || closeness(*found) < closeness(row)) found = &row;
    }
    if (!found || !found->examples.closest) continue;
    const Row& row = *found;
    const Example& closest = *row.examples.closest;
    const oracle::Finding& finding = closest.finding;
    print("{}: {} scenes; the largest error beside what is allowed: {}, {:.3g} of {:.3g} {}: {} {}\n", query, scenes,
          name_of(row), finding.error, finding.allowed, finding.unit, closest.family, closest.index);
    const oracle::Case as_case{row.property->id, row.subject->connectable,
                               closest.family,   ledger.seed,
                               closest.index,    closest.scene,
                               finding,          "",
                               std::nullopt,     folder_of(row.subject->connectable)};
    if (out.empty()) {
      const Json json = oracle::json_of(as_case);
      const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
      print("    {}\n", text.size() <= longest_case ? text : "its case is long: --out FOLDER writes it");
    } else {
      const std::string file = (fs::path(out) / "cases" / (query + ".closest.json")).string();
      oracle::write_case(as_case, file);
      print("    {}\n", replay_command(file, as_case.subject));
    }
  }
}

void print_departures(const Ledger& ledger) {
  for (const Row& row : ledger.results.all()) {
    for (const std::string& departure : row.baseline.departures) print("{}: {}\n", name_of(row), departure);
  }
}

void print_comparison(const std::string& file, const Comparison& counts) {
  print("{}: {} known ({} waived), {} new, {} worse, {} with an expired waiver, {} passing\n", file, counts.known,
        counts.waived, counts.fresh, counts.worse, counts.expired, counts.passing);
  if (counts.not_asked > 0) print("{}: {} not asked or not answered\n", file, counts.not_asked);
}

void print_impacts(const Ledger& ledger) {
  for (const Row& row : ledger.results.all()) {
    if (row.counts.impacts == 0) continue;
    print("{}: {} impacts in {} scenes, {} fail\n", name_of(row), row.counts.impacts, row.answered(), row.counts.fails);
  }
}

/// Of a subject whose card declares a domain, what was asked outside.
void print_beyond(const Ledger& ledger, const TestedSubject& subject) {
  long holds = 0;
  long fails = 0;
  for (const Row* row : ledger.beyond.of(subject)) {
    holds += row->counts.holds;
    fails += row->failures();
  }
  if (holds + fails == 0) return;
  print("{:<16} outside its declared domain, counted apart: {} answers hold, {} fail\n", "", holds, fails);
}

void print_summary(const Ledger& ledger) {
  for (const TestedSubject& subject : ledger.subjects) {
    long holds = 0;
    long fails = 0;
    long silent = 0;
    long refused = 0;
    for (const Row* row : ledger.results.of(subject)) {
      ++(row->failing() ? fails : row->counts.holds > 0 ? holds : silent);
      refused += row->counts.refused;
    }
    print("{:<16} {:>3} properties hold, {:>3} fail, {:>3} not answered{}\n", subject.card.name, holds, fails, silent,
          refused > 0 ? fmt::format("; {} answers refused", refused) : "");
    print_beyond(ledger, subject);
  }
  if (ledger.interrupted) {
    print("interrupted: only what was asked until then counts\n");
  } else if (!ledger.empty_classes.empty()) {
    print("classes without any scene: {}\n", fmt::format("{}", fmt::join(ledger.empty_classes, "; ")));
  }
}

/// Returns whether there are any.
bool print_unanswered(const Ledger& ledger) {
  const std::vector<Unanswered> all = unanswered(ledger);
  for (const auto& [subject, query] : all)
    print("{} {}: no answer, and answers are required\n", subject->card.name, query);
  return !all.empty();
}

struct Baselines {
  std::optional<Baseline> expected;
  std::optional<Baseline> overwritten;  ///< its waivers are kept
  Date today;
};

Date date_of_today(const std::string& word) {
  if (word.empty()) return today();
  const std::optional<Date> date = date_of(word);
  if (!date) throw InputError("--today", "expected a date as 2027-03-31, found \"" + word + '"');
  return *date;
}

/// Reads them before a run of minutes, not after it.
Baselines baselines_of(const RunOptions& options) {
  Baselines all{{}, {}, date_of_today(options.pass.today)};
  if (!options.pass.baseline.empty()) all.expected = read_baseline(options.pass.baseline);
  if (fs::is_regular_file(options.pass.write_baseline)) all.overwritten = read_baseline(options.pass.write_baseline);
  return all;
}

void warn_of_another_run(const std::string& file, const Baseline& baseline, const Ledger& ledger) {
  if (baseline.seed == ledger.seed && baseline.effort == ledger.effort && baseline.cases == ledger.cases) return;
  complain(
      "{}: written of other scenes: --seed {}, --effort {}, {} scenes of each query; now --seed {}, --effort {}, {}",
      file, baseline.seed, baseline.effort, baseline.cases, ledger.seed, ledger.effort, ledger.cases);
}

void write_new_baseline(const std::string& file, const Baselines& baselines, const Ledger& ledger) {
  Baseline baseline = baseline_of(ledger);
  if (baselines.overwritten) keep_waivers(baseline, *baselines.overwritten);
  write_baseline(baseline, file);
  print("{}: {} known\n", file, baseline.failures.size());
}

int written(Ledger ledger, const TrialPlan& plan, const RunOptions& options) {
  name_replay_commands(ledger, plan, options.files.out);
  write_report(options.files.out, ledger);
  write_extras(options, ledger);
  print_summary(ledger);
  print("{}\n", (fs::path(options.files.out) / "index.html").string());
  return ledger.interrupted ? interrupted_exit_code() : 0;
}

int report_shard(const RunOptions& options, const TrialPlan& plan, const MeshSet& meshes, Shard shard) {
  const ShardResult result = run_shard(plan, meshes, shard);
  if (interrupted()) return interrupted_exit_code();
  const std::string file = shard_file(options.files.out, shard);
  write_shard(file, shard, options, plan.subjects, result);
  print("{}: {} units\n", file, result.units.size());
  return 0;
}

}  // namespace

int report(const RunOptions& options) {
  const TrialPlan plan = plan_of(options);
  const std::optional<Shard> shard =
      options.files.shard.empty() ? std::nullopt : std::optional(shard_of(options.files.shard));
  watch_for_interruption();
  prove_adapters(options, plan);
  prepare_places(options);
  const MeshSet meshes = meshes_of(options);
  if (!meshes.absent.empty()) complain("no real meshes: {}", meshes.absent);
  prove_judge(options, plan);
  if (shard) return report_shard(options, plan, meshes, *shard);
  return written(run(plan, meshes), plan, options);
}

int merge(const MergeCommand& command) {
  const ReadShards all = read_shards(command.folder);
  RunOptions options = all.options;
  options.jobs = command.jobs;
  options.files = command.files;
  const TrialPlan plan = plan_of(options);
  watch_for_interruption();
  prepare_places(options);
  return written(merged(plan, meshes_of(options), all.shards), plan, options);
}

int check(const RunOptions& options) {
  const TrialPlan plan = plan_of(options);
  const Baselines baselines = baselines_of(options);
  watch_for_interruption();
  prove_adapters(options, plan);
  prepare_places(options);
  const MeshSet meshes = options.meshes.empty() ? MeshSet{} : meshes_of(options);
  prove_judge(options, plan);
  Ledger ledger = run(plan, meshes);
  std::optional<Comparison> comparison;
  if (baselines.expected && !ledger.interrupted) {
    warn_of_another_run(options.pass.baseline, *baselines.expected, ledger);
    comparison = compare(*baselines.expected, baselines.today, ledger);
  }
  if (!options.files.out.empty()) {
    name_replay_commands(ledger, plan, options.files.out);
    write_report(options.files.out, ledger);
  }
  write_extras(options, ledger);
  print_failing(ledger);
  if (ledger.subjects.size() == 1) print_closest(ledger, options.files.out);
  print_impacts(ledger);
  print_departures(ledger);
  print_summary(ledger);
  if (ledger.interrupted) return interrupted_exit_code();
  if (comparison) print_comparison(options.pass.baseline, *comparison);
  if (!options.pass.write_baseline.empty()) write_new_baseline(options.pass.write_baseline, baselines, ledger);
  const bool silent = options.pass.require_answers && print_unanswered(ledger);
  const bool red = comparison ? !comparison->green() : options.pass.write_baseline.empty() && failing_rows(ledger) > 0;
  return silent || red ? 1 : 0;
}

}  // namespace touchstone::app
