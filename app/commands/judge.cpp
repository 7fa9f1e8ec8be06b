#include "app/commands/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "app/commands/ask.h"
#include "app/motion/given_scene.h"
#include "app/report/finding_words.h"
#include "app/report/report_json.h"
#include "app/system/terminal.h"
#include "app/trial/subject_list.h"
#include "model/input_error.h"
#include "model/json.h"
#include "model/near_names.h"
#include "oracle/case.h"
#include "oracle/process/protocol.h"
#include "oracle/query.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

using oracle::Finding;
using oracle::Outcome;
using properties::Property;

/// One property's verdict on one subject.
struct Judged {
  const Property* property = nullptr;
  Finding finding;
};

/// What one subject said to a query.
struct Heard {
  oracle::Card card;
  Json answer;  ///< {"result": ...}, {"abstains": ...} or {"breaks": ...}, as in the protocol
  std::vector<Judged> judged;
};

struct JudgedQuery {
  std::string query;
  std::optional<Json> truth;  ///< none: its properties are laws, and judge without one exact answer
  std::string no_truth;       ///< why the exact answer is not known
  std::vector<Heard> subjects;
};

std::string name_of(oracle::ScenePart part) {
  switch (part) {
    case oracle::ScenePart::contact:
      return "contact";
    case oracle::ScenePart::raster:
      return "raster";
    case oracle::ScenePart::motion:
      return "motion";
    case oracle::ScenePart::none:
      break;
  }
  return "bodies";
}

bool has(const Scene& scene, oracle::ScenePart part) {
  switch (part) {
    case oracle::ScenePart::contact:
      return scene.contact.has_value();
    case oracle::ScenePart::raster:
      return scene.raster.has_value();
    case oracle::ScenePart::motion:
      return scene.motion.has_value();
    case oracle::ScenePart::none:
      break;
  }
  return true;
}

bool has_two_bodies(const Scene& scene, const oracle::Query& query) {
  return !query.about_two_bodies || scene.bodies.size() >= 2;
}

void require_fitting(const std::string& name, const Scene& scene, const std::string& place) {
  const std::vector<std::string>& known = properties::tested_queries();
  if (std::ranges::count(known, name) == 0) throw InputError("query " + name, unknown_among(name, known));
  const oracle::Query& query = *oracle::find_query(name);
  if (!has_two_bodies(scene, query)) throw InputError(place, "the query " + name + " needs two bodies");
  if (!has(scene, query.needs)) {
    throw InputError(place, "has no \"" + name_of(query.needs) + "\", which the query " + name + " needs");
  }
}

std::vector<std::string> chosen_queries(const JudgeOptions& options, const Scene& scene) {
  for (const std::string& name : options.queries) require_fitting(name, scene, options.scene);
  std::vector<std::string> chosen = properties::tested_queries();
  std::erase_if(chosen, [&](const std::string& name) {
    if (!options.queries.empty()) return std::ranges::count(options.queries, name) == 0;
    const oracle::Query& query = *oracle::find_query(name);
    return !has_two_bodies(scene, query) || !has(scene, query.needs);
  });
  return chosen;
}

template <class T>
Json json_of(const Answer<T>& answer) {
  if (const T* result = std::get_if<T>(&answer)) return {{"result", touchstone::json_of(*result)}};
  if (const Abstains* abstains = std::get_if<Abstains>(&answer)) return {{"abstains", abstains->why}};
  return {{"breaks", std::get<Breaks>(answer).how}};
}

Json answer_of(oracle::Subject& subject, const std::string& query, const Scene& scene) {
  return std::visit([&](const auto ask) { return json_of((subject.*ask)(scene)); }, oracle::find_query(query)->ask);
}

Heard hear(oracle::Subject& subject, const std::string& query, const Scene& scene) {
  Heard heard{subject.card(), answer_of(subject, query, scene), {}};
  for (const Property& property : properties::all()) {
    if (property.query == query) heard.judged.push_back({&property, property.check(scene, subject)});
  }
  return heard;
}

bool all_are(const Heard& heard, Outcome outcome) {
  return std::ranges::all_of(heard.judged, [&](const Judged& one) { return one.finding.outcome == outcome; });
}

/// Long answers, such as trajectories, are cut; --json has them whole.
std::string shortened(const std::string& line) {
  constexpr std::size_t longest = 600;
  return line.size() <= longest ? line : line.substr(0, longest) + " …";
}

/// "holds      distance.value: error 12 ulps of the scene's scale; allowed 250"
void print_verdict(const Judged& judged) {
  const Finding& finding = judged.finding;
  if (finding.outcome == Outcome::outside) return;
  std::string words = judged.property->id;
  if (failed(finding)) words += ": " + judged.property->says;
  if (finding.outcome == Outcome::abstains) words += ": " + finding.why;
  if (finding.outcome == Outcome::holds && !finding.unit.empty()) {
    words += fmt::format(": error {:.4g} {}; allowed {:.4g}", finding.error, finding.unit, finding.allowed);
  }
  print("    {:<10} {}\n", oracle::name_of(finding.outcome), words);
  if (!failed(finding)) return;
  for (const auto& [label, line] : lines_of(finding)) print("      {:<9} {}\n", label, line);
}

void print_heard(const Heard& heard) {
  print("  {} {}\n", heard.card.name, heard.card.version);
  print("    {:<10} {}\n", heard.answer.begin().key(),
        shortened(heard.answer.begin()->dump(-1, ' ', false, Json::error_handler_t::replace)));
  if (heard.answer.contains("abstains") && all_are(heard, Outcome::abstains)) return;
  if (all_are(heard, Outcome::outside)) {
    print("    {:<10} {}\n", "outside", heard.judged.front().finding.why);
    return;
  }
  for (const Judged& judged : heard.judged) print_verdict(judged);
}

void print_words(const std::vector<JudgedQuery>& all) {
  for (const JudgedQuery& one : all) {
    print("{}\n", one.query);
    if (one.truth) {
      print("  truth\n");
      print_answer(*one.truth, "    ");
    }
    if (!one.no_truth.empty()) print("  truth      not known: {}\n", one.no_truth);
    for (const Heard& heard : one.subjects) print_heard(heard);
  }
}

Json json_of(const Heard& heard) {
  Json json = {{"subject", heard.card.name}, {"version", heard.card.version}, {"answer", heard.answer}};
  json["properties"] = Json::array();
  for (const Judged& one : heard.judged) {
    json["properties"].push_back({{"property", one.property->id}, {"finding", oracle::json_of(one.finding)}});
  }
  return json;
}

Json json_of(const std::vector<JudgedQuery>& all) {
  Json queries = Json::array();
  for (const JudgedQuery& one : all) {
    Json json = {{"query", one.query}};
    if (one.truth) json["truth"] = *one.truth;
    if (!one.no_truth.empty()) json["no_truth"] = one.no_truth;
    json["subjects"] = Json::array();
    for (const Heard& heard : one.subjects) json["subjects"].push_back(json_of(heard));
    queries.push_back(std::move(json));
  }
  return {{"touchstone", "judged/1"}, {"queries", std::move(queries)}};
}

bool any_failed(const std::vector<JudgedQuery>& all) {
  for (const JudgedQuery& one : all) {
    for (const Heard& heard : one.subjects) {
      if (std::ranges::any_of(heard.judged, [](const Judged& judged) { return failed(judged.finding); })) return true;
    }
  }
  return false;
}

/// A valid scene may be outside what is known exactly. Then laws judge alone.
JudgedQuery asked(const std::string& query, const GivenScene& given) {
  JudgedQuery one;
  one.query = query;
  if (std::ranges::count(printed_queries(), query) == 0) return one;
  try {
    one.truth = exact_answer(query, given.scene);
  } catch (const InputError& error) {
    one.no_truth = error.what();
  }
  return one;
}

}  // namespace

int judge(const JudgeOptions& options) {
  const GivenScene given = given_scene(options.scene);
  const std::vector<std::string> queries = chosen_queries(options, given.scene);
  std::vector<std::unique_ptr<oracle::Subject>> subjects;
  for (const std::string& name : subject_list(options.subjects)) {
    subjects.push_back(connect(name, limits_of(options.time_limit)));
  }
  std::vector<JudgedQuery> all;
  for (const std::string& query : queries) {
    JudgedQuery one = asked(query, given);
    for (const auto& subject : subjects) one.subjects.push_back(hear(*subject, query, given.scene));
    const bool applies =
        std::ranges::any_of(one.subjects, [](const Heard& heard) { return !all_are(heard, Outcome::outside); });
    if (applies || !options.queries.empty()) all.push_back(std::move(one));
  }
  if (options.json) {
    print_lines(text_of(json_of(all)));
  } else {
    print_words(all);
  }
  return any_failed(all) ? 1 : 0;
}

}  // namespace touchstone::app
