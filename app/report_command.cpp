#include "app/report_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <ranges>
#include <set>
#include <thread>

#include "app/finding_words.h"
#include "app/interruption.h"
#include "app/questions.h"
#include "app/replay_command.h"
#include "app/report_html.h"
#include "app/report_json.h"
#include "app/report_junit.h"
#include "app/roster.h"
#include "app/terminal.h"
#include "app/trial.h"
#include "app/writable.h"
#include "model/input_error.h"
#include "model/json.h"
#include "model/near_names.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

std::set<std::string> known_stems() {
  std::set<std::string> stems;
  for (const properties::Property& property : properties::all()) stems.insert(property.stem);
  return stems;
}

/// The stems of motion are asked when they are named: a flight costs engines and truth up to seconds, and a quick
/// report of all engines with them takes 12 minutes of CPU instead of 7.
bool of_motion(const std::string& stem) {
  return stem == "time_of_impact" || stem == "simulation" || stem == "constraint";
}

std::vector<std::string> chosen_properties(const RunOptions& options) {
  const std::set<std::string> known = known_stems();
  for (const std::string& stem : options.stems) {
    if (!known.contains(stem)) throw InputError("stem " + stem, unknown_among(stem, {known.begin(), known.end()}));
  }
  for (const std::string& id : options.properties) properties::find(id);
  std::vector<std::string> chosen;
  for (const properties::Property& property : properties::all()) {
    const bool by_default = !of_motion(property.stem) || !options.properties.empty();
    const bool of_stems = options.stems.empty() ? by_default : std::ranges::count(options.stems, property.stem) > 0;
    const bool named = options.properties.empty() || std::ranges::count(options.properties, property.id) > 0;
    if (of_stems && named) chosen.push_back(property.id);
  }
  if (chosen.empty()) throw InputError("--properties", "none of them is of the stems that --stems names");
  return chosen;
}

Effort chosen_effort(const RunOptions& options, std::size_t subjects) {
  Effort effort = *std::ranges::find(efforts(), options.effort, &Effort::name);
  if (options.cases > 0) {
    effort.extreme_cases = std::max(1, effort.extreme_cases * options.cases / effort.cases);
    effort.cases = effort.simulations = effort.constraints = options.cases;
    effort.more_impacts = 0;
  } else if (subjects == 1) {
    effort.cases = effort.cases_alone;
    effort.simulations = effort.simulations_alone;
  } else {
    effort.more_impacts = 0;
  }
  return effort;
}

TrialPlan plan_of(const RunOptions& options) {
  TrialPlan plan;
  plan.properties = chosen_properties(options);
  plan.subjects = roster(options.subjects);
  plan.effort = chosen_effort(options, plan.subjects.size());
  plan.seed = options.seed;
  plan.jobs = options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  plan.limits = limits_of(options.time_limit);
  return plan;
}

MeshSet meshes_of(const RunOptions& options) { return read_meshes(options.meshes, options.effort == "quick"); }

/// Before a run of minutes, not after it.
void prepare_places(const RunOptions& options) {
  if (!options.out.empty()) {
    const fs::path cases = fs::path(options.out) / "cases";
    std::error_code error;
    fs::create_directories(cases, error);
    if (error) throw InputError(options.out, error.message());
    require_writable_folder(cases, options.out);
    require_writable_folder(options.out, options.out);
  }
  for (const std::string& file : {options.json, options.junit}) {
    if (!file.empty()) require_writable_file(file);
  }
}

/// Only what a report writes: a folder named cases may hold more than ours.
bool is_case_of_a_report(const fs::path& file) {
  const std::string name = file.filename().string();
  return file.extension() == ".json" &&
         std::ranges::any_of(properties::all(),
                             [&](const properties::Property& property) { return name.starts_with(property.id + "."); });
}

/// The cases have their places before the page and JUnit XML name them.
void name_replay_commands(Ledger& ledger, const TrialPlan& plan, const fs::path& folder) {
  for (Row& row : ledger.rows) {
    if (!row.smallest_case) continue;
    std::optional<double> limit;
    if (row.smallest_case->finding.defect == oracle::Defect::hung) limit = plan.limits.cpu_seconds;
    row.replay_command = replay_command((folder / row.case_file).string(), row.smallest_case->subject, limit);
  }
}

/// The old report goes first and index.html comes last: whoever sees it sees a whole report.
void write_report(const fs::path& folder, const Ledger& ledger) {
  for (const char* file : {"index.html", "report.json", "junit.xml"}) fs::remove(folder / file);
  for (const fs::directory_entry& old : fs::directory_iterator(folder / "cases")) {
    if (is_case_of_a_report(old.path())) fs::remove(old.path());
  }
  for (const Row& row : ledger.rows) {
    if (row.smallest_case) oracle::write_case(*row.smallest_case, (folder / row.case_file).string());
  }
  write_text((folder / "report.json").string(), text_of(report_json(ledger)));
  write_text((folder / "junit.xml").string(), report_junit(ledger));
  write_text((folder / "index.html").string(), report_html(ledger));
}

void write_extras(const RunOptions& options, const Ledger& ledger) {
  if (!options.json.empty()) write_text(options.json, text_of(report_json(ledger)));
  if (!options.junit.empty()) write_text(options.junit, report_junit(ledger));
}

long failing_rows(const Ledger& ledger) { return std::ranges::count_if(ledger.rows, &Row::failing); }

void print_failing(const Ledger& ledger) {
  for (const Row& row : ledger.rows) {
    if (!row.failing()) continue;
    print("{} {}: {} of {} fail, grade {}\n", row.subject, row.property, row.fails + row.breaks, row.answered(),
          oracle::name_of(*row.grade()));
    for (const auto& [label, words] : lines_of(shown_finding(row))) print("    {:<9} {}\n", label, words);
    if (!row.replay_command.empty()) print("    {}\n", row.replay_command);
  }
}

/// Agreement with the truth first: what conserves something is held to bounds of its own.
std::pair<bool, double> closeness(const Row& row) {
  if (!row.closest) return {false, -1};
  return {compares_with_truth(properties::find(row.property)),
          row.closest->finding.error / row.closest->finding.allowed};
}

/// The right answer that came nearest to disagreeing with the truth, of each stem; its case is written, or printed.
void print_closest(const Ledger& ledger, const std::string& out) {
  for (const auto& [stem, scenes] : ledger.scenes) {
    const auto of_stem = [&](const Row& row) { return properties::find(row.property).stem == stem; };
    auto rows = ledger.rows | std::views::filter(of_stem);
    const auto found = std::ranges::max_element(rows, {}, closeness);
    if (found == rows.end() || !found->closest) continue;
    const Row& row = *found;
    const Example& closest = *row.closest;
    const oracle::Finding& finding = closest.finding;
    print("{}: {} scenes; the largest error beside what is allowed: {} {}, {:.3g} of {:.3g} {}: {} {}\n", stem, scenes,
          row.subject, row.property, finding.error, finding.allowed, finding.unit, closest.family, closest.index);
    const auto place = static_cast<std::size_t>(std::ranges::find(ledger.subjects, row.subject, &oracle::Card::name) -
                                                ledger.subjects.begin());
    const oracle::Case as_case{row.property,   ledger.connectables[place],
                               closest.family, ledger.seed,
                               closest.index,  closest.scene,
                               finding,        ""};
    if (out.empty()) {
      const Json json = oracle::json_of(as_case);
      print("    {}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
    } else {
      const std::string file = (fs::path(out) / "cases" / (stem + ".closest.json")).string();
      oracle::write_case(as_case, file);
      print("    {}\n", replay_command(file, as_case.subject));
    }
  }
}

void print_impacts(const Ledger& ledger) {
  for (const Row& row : ledger.rows) {
    if (row.impacts == 0) continue;
    print("{} {}: {} impacts in {} scenes, {} fail\n", row.subject, row.property, row.impacts, row.answered(),
          row.fails);
  }
}

void print_summary(const Ledger& ledger) {
  for (const oracle::Card& card : ledger.subjects) {
    long holds = 0;
    long fails = 0;
    long silent = 0;
    for (const Row& row : ledger.rows) {
      if (row.subject != card.name) continue;
      ++(row.failing() ? fails : row.holds > 0 ? holds : silent);
    }
    print("{:<16} {:>3} properties hold, {:>3} fail, {:>3} not answered\n", card.name, holds, fails, silent);
  }
  if (ledger.interrupted) {
    print("interrupted: only what was asked until then counts\n");
  } else if (!ledger.empty_classes.empty()) {
    print("no scene of these kinds was met: {}\n", fmt::format("{}", fmt::join(ledger.empty_classes, "; ")));
  }
}

}  // namespace

int report(const RunOptions& options) {
  const TrialPlan plan = plan_of(options);
  prepare_places(options);
  watch_for_interruption();
  const MeshSet meshes = meshes_of(options);
  if (!meshes.absent.empty()) complain("no real meshes: {}", meshes.absent);
  Ledger ledger = run(plan, meshes);
  name_replay_commands(ledger, plan, options.out);
  write_report(options.out, ledger);
  write_extras(options, ledger);
  print_summary(ledger);
  print("{}\n", (fs::path(options.out) / "index.html").string());
  return ledger.interrupted ? interrupted_exit_code() : 0;
}

int check(const RunOptions& options) {
  const TrialPlan plan = plan_of(options);
  prepare_places(options);
  watch_for_interruption();
  const MeshSet meshes = options.meshes.empty() ? MeshSet{} : meshes_of(options);
  Ledger ledger = run(plan, meshes);
  if (!options.out.empty()) {
    name_replay_commands(ledger, plan, options.out);
    write_report(options.out, ledger);
  }
  write_extras(options, ledger);
  print_failing(ledger);
  if (ledger.subjects.size() == 1) print_closest(ledger, options.out);
  print_impacts(ledger);
  print_summary(ledger);
  if (ledger.interrupted) return interrupted_exit_code();
  return failing_rows(ledger) > 0 ? 1 : 0;
}

}  // namespace touchstone::app
