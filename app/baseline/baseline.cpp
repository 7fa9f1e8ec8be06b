#include "app/baseline/baseline.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "app/baseline/named_value.h"
#include "app/report/report_json.h"
#include "model/input_error.h"
#include "model/json_node.h"
#include "model/near_names.h"
#include "model/source_text.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

constexpr const char* baseline_format = "baseline/1";

auto key_of(const KnownFailure& failure) { return std::tie(failure.subject, failure.property, failure.cause); }

std::string read_property(const Node& node) {
  std::vector<std::string> ids;
  for (const properties::Property& property : properties::all()) ids.push_back(property.id);
  const std::string id = node.text();
  if (std::ranges::count(ids, id) == 0) {
    node.refuse("no property is called " + Json(id).dump() + "; " + did_you_mean(id, ids));
  }
  return id;
}

std::string read_words(const Node& node) {
  std::string words = node.text();
  if (words.empty()) node.refuse("is empty");
  return words;
}

Waiver read_waiver(const Node& node) {
  node.expect_object({"reason", "link", "expires"});
  const std::string expires = node.at("expires").text();
  const std::optional<Date> date = date_of(expires);
  if (!date) node.at("expires").refuse("expected a date as \"2027-03-31\", found " + Json(expires).dump());
  return {read_words(node.at("reason")), read_words(node.at("link")), *date};
}

KnownFailure read_failure(const Node& node) {
  node.expect_object({"subject", "property", "cause", "grade", "waiver"});
  KnownFailure failure;
  failure.subject = read_words(node.at("subject"));
  failure.property = read_property(node.at("property"));
  failure.cause = read_named(node.at("cause"), oracle::Defect::phantom, oracle::Defect::garbage);
  failure.grade = read_named(node.at("grade"), oracle::Grade::A_minus, oracle::Grade::F);
  if (const auto waiver = node.find("waiver")) failure.waiver = read_waiver(*waiver);
  return failure;
}

Baseline read_baseline_json(const Json& json) {
  const Node node(json, "");
  if (const std::string format = node.at("touchstone").text(); format != baseline_format) {
    node.at("touchstone").refuse("expected \"" + std::string(baseline_format) + "\", found " + Json(format).dump());
  }
  node.expect_object({"touchstone", "seed", "effort", "cases_per_query", "failures"});
  Baseline baseline;
  if (!json.at("seed").is_number_unsigned()) node.at("seed").refuse("expected an integer from 0 to 2^64 - 1");
  baseline.seed = json.at("seed").get<std::uint64_t>();
  baseline.effort = node.at("effort").text();
  baseline.cases = node.at("cases_per_query").index();
  std::set<std::tuple<std::string, std::string, oracle::Defect>> known;
  const Node failures = node.at("failures");
  for (int i = 0; i < failures.size(); ++i) {
    baseline.failures.push_back(read_failure(failures[i]));
    if (!known.insert(key_of(baseline.failures.back())).second) {
      failures[i].refuse("a second entry for the same subject, property and cause");
    }
  }
  return baseline;
}

Json json_of(const KnownFailure& failure) {
  Json json = {{"subject", failure.subject},
               {"property", failure.property},
               {"cause", oracle::name_of(failure.cause)},
               {"grade", oracle::name_of(failure.grade)}};
  if (failure.waiver) {
    json["waiver"] = {{"reason", failure.waiver->reason},
                      {"link", failure.waiver->link},
                      {"expires", text_of(failure.waiver->expires)}};
  }
  return json;
}

}  // namespace

Baseline baseline_of(const Ledger& ledger) {
  Baseline baseline{ledger.seed, ledger.effort, ledger.cases, {}};
  for (const Row& row : ledger.results.all()) {
    for (const auto& [cause, grade] : row.worst_grades) {
      baseline.failures.push_back({row.subject->card.name, row.property->id, cause, grade, std::nullopt});
    }
  }
  return baseline;
}

void keep_waivers(Baseline& baseline, const Baseline& old) {
  for (KnownFailure& failure : baseline.failures) {
    const auto same = std::ranges::find_if(old.failures, [&](const auto& f) { return key_of(f) == key_of(failure); });
    if (same != old.failures.end()) failure.waiver = same->waiver;
  }
}

Baseline read_baseline(const std::string& path) {
  const SourceText source = read_source(path);
  return read_document(source.text, source.name, read_baseline_json);
}

void write_baseline(const Baseline& baseline, const std::string& path) {
  Json json = {{"touchstone", baseline_format},
               {"seed", baseline.seed},
               {"effort", baseline.effort},
               {"cases_per_query", baseline.cases}};
  json["failures"] = Json::array();
  for (const KnownFailure& failure : baseline.failures) json["failures"].push_back(json_of(failure));
  write_text(path, text_of(json));
}

}  // namespace touchstone::app
