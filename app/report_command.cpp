#include "app/report_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <thread>

#include "app/interruption.h"
#include "app/report_html.h"
#include "app/report_json.h"
#include "app/report_junit.h"
#include "app/roster.h"
#include "app/trial.h"
#include "model/input_error.h"
#include "model/json.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

std::set<std::string> known_stems() {
  std::set<std::string> stems;
  for (const properties::Property& property : properties::all()) stems.insert(property.stem);
  return stems;
}

std::vector<std::string> chosen_properties(const RunOptions& options) {
  const std::set<std::string> known = known_stems();
  for (const std::string& stem : options.stems) {
    if (!known.contains(stem))
      throw InputError("stem " + stem, fmt::format("unknown; there are {}", fmt::join(known, ", ")));
  }
  for (const std::string& id : options.properties) properties::find(id);
  std::vector<std::string> chosen;
  for (const properties::Property& property : properties::all()) {
    const bool of_stems = options.stems.empty() || std::ranges::count(options.stems, property.stem) > 0;
    const bool named = options.properties.empty() || std::ranges::count(options.properties, property.id) > 0;
    if (of_stems && named) chosen.push_back(property.id);
  }
  if (chosen.empty()) throw InputError("--properties", "none of them is of the stems that --stems names");
  return chosen;
}

Effort chosen_effort(const RunOptions& options) {
  Effort effort = *std::ranges::find(efforts(), options.effort, &Effort::name);
  if (options.cases > 0) {
    effort.extreme_cases = std::max(1, effort.extreme_cases * options.cases / effort.cases);
    effort.cases = options.cases;
  }
  return effort;
}

TrialPlan plan_of(const RunOptions& options) {
  TrialPlan plan;
  plan.properties = chosen_properties(options);
  plan.effort = chosen_effort(options);
  plan.subjects = roster(options.subjects);
  plan.seed = options.seed;
  plan.jobs = options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  plan.limits.cpu_seconds = options.time_limit;
  plan.limits.wall_seconds = 10 * options.time_limit;
  return plan;
}

MeshSet meshes_of(const RunOptions& options) { return read_meshes(options.meshes, options.effort == "quick"); }

/// A new report takes the place of the old one only when it is whole; index.html, written last, says that it is.
void write_report(const std::string& folder, const Ledger& ledger) {
  std::error_code error;
  fs::create_directories(fs::path(folder) / "cases", error);
  if (error) throw InputError(folder, error.message());
  fs::remove(fs::path(folder) / "index.html");
  for (const auto& old : fs::directory_iterator(fs::path(folder) / "cases")) {
    if (old.path().extension() == ".json") fs::remove(old.path());
  }
  for (const Row& row : ledger.rows) {
    if (row.smallest_case) oracle::write_case(*row.smallest_case, (fs::path(folder) / row.case_file).string());
  }
  write_text((fs::path(folder) / "report.json").string(), text_of(report_json(ledger)));
  write_text((fs::path(folder) / "junit.xml").string(), report_junit(ledger));
  write_text((fs::path(folder) / "index.html").string(), report_html(ledger));
}

void write_extras(const RunOptions& options, const Ledger& ledger) {
  if (!options.json.empty()) write_text(options.json, text_of(report_json(ledger)));
  if (!options.junit.empty()) write_text(options.junit, report_junit(ledger));
}

long failing_rows(const Ledger& ledger) { return std::ranges::count_if(ledger.rows, &Row::failing); }

void print_failing(const Ledger& ledger, const std::string& out) {
  for (const Row& row : ledger.rows) {
    if (!row.failing()) continue;
    const oracle::Finding& finding = row.smallest_case ? row.smallest_case->finding : row.worst->finding;
    fmt::print("{} {}: {} of {} fail ({}, grade {}); observed {}; expected {}\n", row.subject, row.property,
               row.fails + row.breaks, row.holds + row.fails + row.breaks, oracle::name_of(finding.defect),
               oracle::name_of(*row.grade()), finding.observed.empty() ? finding.why : finding.observed,
               finding.expected);
    if (!out.empty() && !row.case_file.empty()) fmt::print("    touchstone replay {}/{}\n", out, row.case_file);
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
    fmt::print("{:<16} {:>3} properties hold, {:>3} fail, {:>3} not answered\n", card.name, holds, fails, silent);
  }
  if (!ledger.empty_classes.empty())
    fmt::print("no scene of these kinds was met: {}\n", fmt::join(ledger.empty_classes, "; "));
  if (ledger.interrupted) fmt::print("interrupted: what was asked until then is all that counts\n");
}

}  // namespace

int report(const RunOptions& options) {
  const TrialPlan plan = plan_of(options);
  const MeshSet meshes = meshes_of(options);
  if (!meshes.absent.empty()) fmt::print(stderr, "touchstone: no real meshes: {}\n", meshes.absent);
  const Ledger ledger = run(plan, meshes);
  write_report(options.out, ledger);
  write_extras(options, ledger);
  print_summary(ledger);
  fmt::print("{}\n", (fs::path(options.out) / "index.html").string());
  return ledger.interrupted ? interrupted_exit_code : 0;
}

int check(const RunOptions& options) {
  const TrialPlan plan = plan_of(options);
  const MeshSet meshes = options.meshes.empty() ? MeshSet{} : meshes_of(options);
  const Ledger ledger = run(plan, meshes);
  if (!options.out.empty()) write_report(options.out, ledger);
  write_extras(options, ledger);
  print_failing(ledger, options.out);
  print_summary(ledger);
  if (ledger.interrupted) return interrupted_exit_code;
  return failing_rows(ledger) > 0 ? 1 : 0;
}

}  // namespace touchstone::app
