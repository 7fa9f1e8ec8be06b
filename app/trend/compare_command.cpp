#include "app/trend/compare_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/report/report_json.h"
#include "app/system/terminal.h"
#include "app/trend/trend.h"
#include "model/input_error.h"
#include "model/near_names.h"

namespace touchstone::app {
namespace {

void expect_subject(const ReportFile& report, const std::string& name) {
  if (report.versions.contains(name)) return;
  std::vector<std::string> names;
  for (const auto& [known, version] : report.versions) names.push_back(known);
  throw InputError("--subjects",
                   fmt::format("{} has no subject \"{}\"; {}", report.path, name, did_you_mean(name, names)));
}

std::map<std::string, std::string> chosen_pairs(const CompareOptions& options, const ReportFile& before,
                                                const ReportFile& after) {
  std::map<std::string, std::string> pairs;
  for (const std::string& word : options.subjects) {
    const std::size_t sign = word.find('=');
    const std::string old_name = word.substr(0, sign);
    const std::string new_name = sign == std::string::npos ? word : word.substr(sign + 1);
    expect_subject(before, old_name);
    expect_subject(after, new_name);
    pairs[old_name] = new_name;
  }
  if (!options.subjects.empty()) return pairs;
  for (const auto& [name, version] : before.versions) {
    if (after.versions.contains(name)) pairs[name] = name;
  }
  if (pairs.empty()) {
    throw InputError("compare", fmt::format("no subject is in both {} and {}; name two as --subjects OLD=NEW",
                                            before.path, after.path));
  }
  return pairs;
}

std::string words_of(const ReportedRow& row) {
  if (row.answered() == 0) return "not answered";
  if (row.failures == 0) return fmt::format("holds on {}", row.holds);
  std::string words = fmt::format("{} of {} fail", row.failures, row.answered());
  if (row.grade) words += ", grade " + oracle::name_of(*row.grade);
  for (const auto& [name, count] : row.defects) words += fmt::format(", {} {}", count, name);
  if (!row.largest_error.empty()) words += ", error up to " + row.largest_error;
  return words;
}

std::string words_of(const ReportedRow* row) { return row == nullptr ? "not asked" : words_of(*row); }

/// Where the case of a row is, as a path that can be given to `replay`.
std::string case_of(const ReportFile& report, const ReportedRow& row) {
  return (std::filesystem::path(report.path).parent_path() / row.case_file).string();
}

void print_trend(const Trend& trend, const ReportFile& before, const ReportFile& after) {
  const std::string &old_version = before.versions.at(trend.before), &new_version = after.versions.at(trend.after);
  print("{} {} -> {} {}: {} rows hold in both, {} fail alike, {} are answered by neither, {} changed\n", trend.before,
        old_version, trend.after, new_version, trend.holds, trend.fails, trend.unanswered, trend.changes.size());
  for (const ChangedRow& row : trend.changes) {
    const std::string& property = (row.after ? row.after : row.before)->property;
    print("  {:<10} {}\n    before   {}\n    now      {}\n", name_of(row.change), property, words_of(row.before),
          words_of(row.after));
    if (row.change <= Change::worse && !row.after->case_file.empty())
      print("    replay   touchstone replay {}\n", case_of(after, *row.after));
  }
}

Json json_of(const ReportedRow* row) {
  if (row == nullptr) return nullptr;
  Json json = {{"holds", row->holds}, {"failures", row->failures}};
  if (row->grade) json["grade"] = oracle::name_of(*row->grade);
  if (!row->defects.empty()) json["defects"] = row->defects;
  if (!row->largest_error.empty()) json["largest_error"] = row->largest_error;
  if (!row->case_file.empty()) json["case"] = row->case_file;
  return json;
}

Json json_of(const std::vector<Trend>& all, const ReportFile& before, const ReportFile& after) {
  Json json = {{"touchstone", "trend/1"}, {"same_scenes", before.asks_the_scenes_of(after)}};
  json["subjects"] = Json::array();
  for (const Trend& trend : all) {
    Json one = {{"before", {{"name", trend.before}, {"version", before.versions.at(trend.before)}}},
                {"after", {{"name", trend.after}, {"version", after.versions.at(trend.after)}}},
                {"hold", trend.holds},
                {"fail", trend.fails},
                {"unanswered", trend.unanswered}};
    one["changes"] = Json::array();
    for (const ChangedRow& row : trend.changes) {
      one["changes"].push_back({{"change", name_of(row.change)},
                                {"property", (row.after ? row.after : row.before)->property},
                                {"before", json_of(row.before)},
                                {"after", json_of(row.after)}});
    }
    json["subjects"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

int compare_reports(const CompareOptions& options) {
  const ReportFile before = read_report(options.before), after = read_report(options.after);
  const std::vector<Trend> all = trends(before, after, chosen_pairs(options, before, after));
  if (options.json) {
    print_lines(text_of(json_of(all, before, after)));
  } else {
    if (!before.asks_the_scenes_of(after)) {
      print(
          "The reports asked different scenes (effort {}, seed {}, {} a query; effort {}, seed {}, {} a query): how "
          "often a row fails is not compared.\n",
          before.effort, before.seed, before.cases, after.effort, after.seed, after.cases);
    }
    for (const Trend& trend : all) print_trend(trend, before, after);
  }
  return std::ranges::any_of(all, &Trend::regressed) ? 1 : 0;
}

}  // namespace touchstone::app
