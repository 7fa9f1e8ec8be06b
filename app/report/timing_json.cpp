#include "app/report/timing_json.h"

#include <cmath>
#include <utility>

#include "app/system/version.h"
#include "app/trial/subject_list.h"

namespace touchstone::app {
namespace {

void add_quantiles(const RunTimes& times, Json& json) {
  json["questions"] = times.total();
  json["tenth"] = times.quantile(0.1);
  json["median"] = times.quantile(0.5);
  json["ninetieth"] = times.quantile(0.9);
}

Json times_of(const Ledger& ledger) {
  Json all = Json::array();
  for (const auto& [query, profile] : ledger.profiles) {
    for (const TestedSubject& subject : ledger.subjects) {
      const RunTimes& times = profile.times.answers[subject.index];
      if (times.total() == 0) continue;
      Json json = {
          {"query", query}, {"subject", subject.card.name}, {"in_process", is_in_process(subject.connectable)}};
      add_quantiles(times, json);
      all.push_back(std::move(json));
    }
  }
  return all;
}

Json plans_of(const Ledger& ledger) {
  Json all = Json::array();
  for (const auto& [query, profile] : ledger.profiles) {
    for (const auto& [name, times] :
         {std::pair("planned", &profile.times.plans.planned), std::pair("all parts", &profile.times.plans.all_parts)}) {
      if (times->total() == 0) continue;
      Json json = {{"query", query}, {"plan", name}};
      add_quantiles(*times, json);
      all.push_back(std::move(json));
    }
  }
  return all;
}

/// An array for each class: its number, and how many times are in it.
Json json_of(const RunTimes& times) {
  Json json = Json::array();
  for (const auto& [k, count] : times.classes) json.push_back({k, count});
  return json;
}

RunTimes read_classes(const Node& node) {
  constexpr double most_classes = 1 << 16;
  RunTimes times;
  for (int c = 0; c < node.size(); ++c) {
    const Node entry = node[c];
    entry.expect_size(2);
    const double k = entry[0].number();
    if (!(std::abs(k) < most_classes) || k != std::floor(k)) entry[0].refuse("expected the number of a class");
    times.classes[static_cast<int>(k)] = entry[1].index();
  }
  return times;
}

}  // namespace

Json timing_json(const Ledger& ledger) {
  return {{"touchstone", "timing/1"},   {"version", version},        {"unit", "s"},
          {"a_time_is", time_contents}, {"times", times_of(ledger)}, {"plans", plans_of(ledger)}};
}

Json json_of(const std::map<std::string, QueryTimes>& times) {
  Json json = Json::object();
  for (const auto& [query, of_query] : times) {
    Json answers = Json::array();
    for (const RunTimes& subject : of_query.answers) answers.push_back(json_of(subject));
    json[query] = {{"answers", std::move(answers)},
                   {"planned", json_of(of_query.plans.planned)},
                   {"all_parts", json_of(of_query.plans.all_parts)}};
  }
  return json;
}

std::map<std::string, QueryTimes> read_times(const Json& json, const Node& node) {
  std::map<std::string, QueryTimes> all;
  for (const auto& [query, of_query] : json.items()) {
    const Node entry = node.at(query);
    const Node answers = entry.at("answers"), planned = entry.at("planned"), all_parts = entry.at("all_parts");
    QueryTimes& times = all[query];
    for (int s = 0; s < answers.size(); ++s) {
      times.answers.push_back(read_classes(answers[s]));
    }
    times.plans = {read_classes(planned), read_classes(all_parts)};
  }
  return all;
}

}  // namespace touchstone::app
