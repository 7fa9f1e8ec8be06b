#include "app/report/report_sarif.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/report/finding_words.h"
#include "app/system/version.h"
#include "properties/clause.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

/// RFC 3986: what is neither unreserved nor a slash is percent-encoded.
std::string uri_of(const std::string& path) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string uri;
  for (const char c : path) {
    uri += plain.find(c) != std::string_view::npos ? std::string(1, c)
                                                   : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

std::string uri_of_file(const fs::path& file) {
  const fs::path whole = fs::absolute(file).lexically_normal();
  const std::string relative = whole.lexically_relative(fs::current_path()).generic_string();
  return relative.starts_with("..") ? "file://" + uri_of(whole.generic_string()) : uri_of(relative);
}

Json rule(const properties::Property& property) {
  std::string clauses;
  for (const std::string& id : property.clauses) {
    const properties::Clause& clause = properties::clause(id);
    clauses += fmt::format("{}{}: {}", clauses.empty() ? "" : " ", clause.id, clause.says);
  }
  return {{"id", property.id},
          {"shortDescription", {{"text", property.says}}},
          {"fullDescription", {{"text", clauses.empty() ? property.says : clauses}}}};
}

const char* level_of(oracle::Grade grade) {
  return grade >= oracle::Grade::D ? "error" : grade >= oracle::Grade::B ? "warning" : "note";
}

std::string message(const Row& row) {
  std::string words = fmt::format("{} {}: {}, grade {}.", row.subject->card.name, row.property->id, share_of(row),
                                  oracle::name_of(*row.grade()));
  for (const std::string& departure : row.baseline.departures) words += '\n' + departure;
  for (const auto& [label, text] : lines_of(shown_finding(row))) words += fmt::format("\n{}: {}", label, text);
  if (!row.minimised.replay_command.empty()) words += "\nreplay: " + row.minimised.replay_command;
  return words;
}

Json location(const Row& row, const std::string& folder) {
  const std::string name = row.subject->card.name;
  Json json;
  if (!folder.empty() && !row.minimised.case_file.empty()) {
    json["physicalLocation"] = {
        {"artifactLocation", {{"uri", uri_of_file(fs::path(folder) / row.minimised.case_file)}}},
        {"region", {{"startLine", 1}}}};
  }
  json["logicalLocations"] = Json::array({{{"name", name}, {"fullyQualifiedName", name + '/' + row.property->id}}});
  return json;
}

Json result(const Row& row, std::size_t rule_index, const std::string& folder) {
  const oracle::Finding& finding = shown_finding(row);
  const std::string defect = oracle::name_of(finding.defect);
  Json json = {{"ruleId", row.property->id},
               {"ruleIndex", rule_index},
               {"level", level_of(*row.grade())},
               {"message", {{"text", message(row)}}}};
  json["locations"] = Json::array({location(row, folder)});
  json["partialFingerprints"] = {{"touchstone/1", row.subject->card.name + '/' + row.property->id + '/' + defect}};
  if (!row.baseline.known.empty()) {
    json["suppressions"] =
        Json::array({{{"kind", "external"}, {"status", "accepted"}, {"justification", row.baseline.known}}});
  }
  json["properties"] = {{"subject", row.subject->card.name},      {"defect", defect},
                        {"grade", oracle::name_of(*row.grade())}, {"failures", row.failures()},
                        {"refused", row.counts.refused},          {"answered", row.answered()}};
  if (row.minimised.result) {
    json["properties"]["scene"] = touchstone::json_of(row.minimised.result->scene);
    if (row.minimised.result->changed) {
      json["properties"]["changed_scene"] = touchstone::json_of(row.minimised.result->changed->scene);
    }
  }
  return json;
}

}  // namespace

Json report_sarif(const Ledger& ledger, const std::string& folder) {
  const ResultMatrix::Properties& properties = ledger.results.tested_properties();
  Json rules = Json::array();
  for (const properties::Property* property : properties) rules.push_back(rule(*property));
  Json results = Json::array();
  for (const TestedSubject& subject : ledger.subjects) {
    for (const Row* row : ledger.results.of(subject)) {
      if (!row->failing()) continue;
      const auto index = static_cast<std::size_t>(std::ranges::find(properties, row->property) - properties.begin());
      results.push_back(result(*row, index, folder));
    }
  }
  Json run;
  run["tool"]["driver"] = {{"name", "touchstone"}, {"version", version}, {"rules", std::move(rules)}};
  run["invocations"] = Json::array({{{"executionSuccessful", !ledger.interrupted}}});
  run["results"] = std::move(results);
  return {{"$schema", "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"},
          {"version", "2.1.0"},
          {"runs", Json::array({std::move(run)})}};
}

}  // namespace touchstone::app
