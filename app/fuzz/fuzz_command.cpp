#include "app/fuzz/fuzz_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/adapter/proven.h"
#include "app/fuzz/fuzz_run.h"
#include "app/report/finding_words.h"
#include "app/report/replay_command.h"
#include "app/system/file_names.h"
#include "app/system/interruption.h"
#include "app/system/terminal.h"
#include "app/system/writable.h"
#include "app/trial/effort.h"
#include "app/trial/subject_list.h"
#include "model/input_error.h"
#include "model/json.h"
#include "model/near_names.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;
using properties::Property;

constexpr int minimise_budget = 800;  ///< as of effort standard
constexpr int minimise_budget_of_trajectories = 60;

std::vector<const Property*> chosen_properties(const FuzzCommand& command) {
  std::vector<const Property*> chosen;
  for (const std::string& id : command.properties) {
    if (properties::find(id).query != command.query) throw InputError(id, "is no property of " + command.query);
  }
  for (const Property& property : properties::all()) {
    const bool named = command.properties.empty() || std::ranges::count(command.properties, property.id) > 0;
    if (property.query == command.query && named) chosen.push_back(&property);
  }
  return chosen;
}

std::string usual_subject(const std::string& query) {
  const bool fast_answers = std::ranges::count(oracle::subjects::make_fast()->card().answers, query) > 0;
  return fast_answers ? "inproc:fast" : "inproc:reference";
}

FuzzPlan plan_of(const FuzzCommand& command) {
  FuzzPlan plan;
  plan.query = command.query;
  plan.properties = chosen_properties(command);
  plan.seed = command.seed;
  plan.executions = command.executions;
  plan.seconds = command.time;
  if (!command.time && !command.executions) plan.seconds = default_fuzz_time;
  if (command.empty_corpus) plan.draws = 0;
  plan.first_failure = command.first_failure;
  plan.enlarge_budget = command.enlarge;
  if (!command.first_failure) {
    plan.minimise_budget = is_simulated(command.query) ? minimise_budget_of_trajectories : minimise_budget;
  }
  return plan;
}

void prepare_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder, error.message());
  require_writable_folder(folder, folder);
}

/// A finding's file, and how to ask it again; likewise of its largest error, if there is one (else empty).
struct Written {
  std::string file;
  std::string replay;
  std::string largest_file = {};
  std::string largest_replay = {};
};

oracle::Case largest_case(const Example& largest, const oracle::Case& smallest) {
  oracle::Case made = smallest;
  made.scene = largest.scene;
  made.finding = largest.finding;
  made.changed.reset();
  made.snippet.clear();
  made.note = "touchstone fuzz --enlarge: the largest error that was found";
  return made;
}

Written write(FuzzFinding& finding, const FuzzCommand& command, const std::string& connectable,
              const std::string& file_name) {
  const std::string name =
      fmt::format("{}.{}.{}", finding.row.property->id, name_of(finding.smallest.finding.defect), file_name);
  const auto path = [&](const char* ending) { return (fs::path(command.out) / (name + ending)).string(); };
  const std::string file = path(".json");
  finding.smallest.subject = connectable;
  finding.smallest.folder = folder_of(connectable);
  oracle::write_case(finding.smallest, file);
  Written written{file, replay_command(file, connectable)};
  if (finding.largest) {
    written.largest_file = path(".largest.json");
    written.largest_replay = replay_command(written.largest_file, connectable);
    oracle::write_case(largest_case(*finding.largest, finding.smallest), written.largest_file);
  }
  return written;
}

/// "8.1e+15 ulps of the scene's scale, 0.36 times the exact value, 0.9 times the size of the smaller body"
std::string text_of_error(const oracle::Finding& finding) {
  std::string text = fmt::format("{:.3g} {}", finding.error, finding.unit);
  if (finding.relative) text += fmt::format(", {:.3g} times the exact value", *finding.relative);
  if (finding.of_body) text += fmt::format(", {:.3g} times the size of the smaller body", *finding.of_body);
  return text;
}

/// Of all answers that hold, the one with the largest error beside what is allowed; null if no error has a size.
const Example* nearest(const FuzzResult& result, const Property** property) {
  const Example* found = nullptr;
  const auto share = [](const Example& e) { return e.finding.error / e.finding.allowed; };
  for (const Row& row : result.holding) {
    if (!row.examples.closest || (found != nullptr && share(*row.examples.closest) <= share(*found))) continue;
    found = &*row.examples.closest;
    *property = row.property;
  }
  return found;
}

double rate(long count, const FuzzResult& result) {
  return static_cast<double>(count) / std::max(result.seconds, 1e-3);
}

long marks_reached(const FuzzResult& result) {
  return std::ranges::count_if(result.coverage.marks, [](std::uint64_t count) { return count > 0; });
}

Json json_of(const FuzzFinding& finding, const Written& written) {
  const oracle::Size size = oracle::size_of(finding.smallest.scene);
  Json json{{"property", finding.row.property->id},
            {"defect", name_of(finding.smallest.finding.defect)},
            {"grade", oracle::name_of(*finding.row.grade())},
            {"first_execution", finding.execution},
            {"failures", finding.row.failures()},
            {"largest_error", finding.row.largest_error.size},
            {"unit", finding.row.largest_error.unit},
            {"bodies", size.bodies},
            {"vertices_per_body_max", size.vertices_per_body_max},
            {"significant_bits_max", size.significant_bits_max},
            {"case", written.file},
            {"replay", written.replay}};
  json["finding"] = oracle::json_of(finding.smallest.finding);
  if (finding.largest) {
    json["largest"] = {{"finding", oracle::json_of(finding.largest->finding)},
                       {"case", written.largest_file},
                       {"replay", written.largest_replay}};
  }
  return json;
}

void print_json(const FuzzCommand& command, const FuzzResult& result, const std::vector<Written>& written) {
  Json json{{"query", command.query},
            {"subject", result.card.name},
            {"version", result.card.version},
            {"seed", command.seed},
            {"executions", result.executions},
            {"judged", result.judged},
            {"verdicts", result.verdicts},
            {"beyond", result.beyond},
            {"marks_reached", marks_reached(result)},
            {"signals", result.coverage.signals},
            {"kept", result.coverage.kept}};
  const Property* property = nullptr;
  if (const Example* example = nearest(result, &property)) {
    json["nearest"] = {{"property", property->id},
                       {"error", example->finding.error},
                       {"allowed", example->finding.allowed},
                       {"unit", example->finding.unit},
                       {"execution", example->index}};
  }
  json["findings"] = Json::array();
  for (std::size_t f = 0; f < written.size(); ++f) json["findings"].push_back(json_of(result.findings[f], written[f]));
  json["contradictions"] = Json::array();
  for (const Contradiction& c : result.contradictions) {
    json["contradictions"].push_back({{"execution", c.execution}, {"what", c.what}, {"scene", json_of(c.scene)}});
  }
  json["interrupted"] = result.interrupted;
  json["seconds"] = result.seconds;
  json["executions_per_second"] = rate(result.executions, result);
  json["judged_per_second"] = rate(result.judged, result);
  print_lines(touchstone::text_of(json));
}

void print_words(const FuzzCommand& command, const FuzzResult& result, const std::vector<Written>& written) {
  print("{} of {} {}, seed {}: {} executions; {:.0f} a second\n", command.query, result.card.name, result.card.version,
        command.seed, result.executions, rate(result.executions, result));
  print("asked under all properties: {} of them, {} verdicts; {:.0f} a second\n", result.judged, result.verdicts,
        rate(result.judged, result));
  print("coverage: {} of {} marks of fast, {} signals, {} scenes kept\n", marks_reached(result),
        result.coverage.marks.size(), result.coverage.signals, result.coverage.kept);
  if (result.beyond > 0) print("outside the subject's declared domain, not counted: {} verdicts\n", result.beyond);
  const Property* property = nullptr;
  if (const Example* example = nearest(result, &property)) {
    const oracle::Finding& finding = example->finding;
    print("nearest to a failure, of what holds: {}, {:.3g} of {:.3g} {}, execution {}\n", property->id, finding.error,
          finding.allowed, finding.unit, example->index);
  }
  for (const Contradiction& c : result.contradictions) {
    print("a fault of touchstone: execution {}: {}\n{}\n", c.execution, c.what, touchstone::text_of(json_of(c.scene)));
  }
  print("findings: {}{}\n", result.findings.size(), result.interrupted ? "; interrupted" : "");
  for (std::size_t f = 0; f < written.size(); ++f) {
    const FuzzFinding& finding = result.findings[f];
    const Row& row = finding.row;
    const std::string largest =
        row.largest_error.unit.empty() || row.largest_error.unit == oracle::without_size
            ? ""
            : fmt::format(", the largest error {:.3g} {}", row.largest_error.size, row.largest_error.unit);
    print("{}: {}, grade {}: {} scenes, first in execution {}{}\n", row.property->id,
          name_of(finding.smallest.finding.defect), oracle::name_of(*row.grade()), row.failures(), finding.execution,
          largest);
    for (const auto& [label, words] : lines_of(finding.smallest.finding)) print("    {:<9} {}\n", label, words);
    print("    {:<9} {}\n", "scene", text_of(oracle::size_of(finding.smallest.scene)));
    print("    {}\n", written[f].replay);
    if (finding.largest) {
      print("    {:<9} {}\n    {}\n", "enlarged", text_of_error(finding.largest->finding), written[f].largest_replay);
    }
  }
}

}  // namespace

int fuzz(const FuzzCommand& command) {
  const FuzzPlan plan = plan_of(command);
  const std::string connectable = command.subject.empty() ? usual_subject(command.query) : command.subject;
  const oracle::PipeLimits limits = limits_of(command.time_limit);
  const std::unique_ptr<oracle::Subject> subject = connect(connectable, limits);
  watch_for_interruption();
  if (!command.skip_adapter_check) require_proven_adapters({connectable}, {command.query}, limits);
  prepare_folder(command.out);
  FuzzResult result = fuzz(plan, *subject);
  const std::string file_name = names_of_files({result.card}).front();
  std::vector<Written> written;
  for (FuzzFinding& finding : result.findings) {
    written.push_back(write(finding, command, connectable, file_name));
  }
  (command.json ? print_json : print_words)(command, result, written);
  if (result.interrupted) return interrupted_exit_code();
  if (!result.contradictions.empty()) return fault_exit_code;
  return result.findings.empty() ? 0 : 1;
}

}  // namespace touchstone::app
