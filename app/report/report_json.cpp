#include "app/report/report_json.h"

#include <cmath>

#include "app/system/version.h"
#include "app/trial/causes.h"
#include "oracle/process/protocol.h"

namespace touchstone::app {
namespace {

Json json_of(const oracle::Size& size) {
  return {{"bodies", size.bodies},
          {"vertices_per_body", size.vertices_per_body_max},
          {"significant_bits", size.significant_bits_max}};
}

Json json_of(const Example& example) {
  return {{"family", example.family}, {"index", example.index}, {"finding", oracle::json_of(example.finding)}};
}

Json grades_of(const Row& row) {
  Json grades;
  for (std::size_t g = 0; g < row.grades.size(); ++g) {
    grades[oracle::name_of(static_cast<oracle::Grade>(g))] = row.grades[g];
  }
  return grades;
}

/// JSON has no infinity, so an infinite number becomes "inf".
Json number(double x) { return std::isfinite(x) ? Json(x) : Json("inf"); }

/// "2^3" counts the errors above 2^2 and up to 2^3.
Json json_of(const ErrorHistogram& errors) {
  Json json = {{"unit", errors.unit}, {"largest", number(errors.largest)}};
  if (errors.exact > 0) json["at_most"]["0"] = errors.exact;
  for (const auto& [power, count] : errors.powers) json["at_most"]["2^" + std::to_string(power)] = count;
  if (errors.infinite > 0) json["at_most"]["inf"] = errors.infinite;
  return json;
}

Json json_of(const Row& row) {
  Json json = {
      {"property", row.property->id},  {"subject", row.subject->card.name}, {"holds", row.counts.holds},
      {"fails", row.counts.fails},     {"abstains", row.counts.abstains},   {"breaks", row.counts.breaks},
      {"refused", row.counts.refused}, {"outside", row.counts.outside},     {"not_asked", row.counts.not_asked}};
  if (row.counts.unanswered > 0) json["unanswered"] = row.counts.unanswered;
  if (row.counts.beyond > 0) json["beyond"] = row.counts.beyond;
  if (const auto grade = row.grade()) {
    json["grade"] = oracle::name_of(*grade);
    json["grades"] = grades_of(row);
    if (!row.largest_error.unit.empty())
      json["largest_error"] = {{"error", number(row.largest_error.size)}, {"unit", row.largest_error.unit}};
  }
  if (row.counts.impacts > 0) json["impacts"] = row.counts.impacts;
  if (row.errors.total() > 0) json["errors"] = json_of(row.errors);
  if (!row.why_abstains.empty()) json["why_abstains"] = row.why_abstains;
  if (!row.failing()) return json;
  json["share"] = static_cast<double>(row.failures()) / static_cast<double>(row.answered());
  for (const auto& [defect, count] : row.defects) json["defects"][oracle::name_of(defect)] = count;
  json["worst"] = json_of(*row.examples.worst);
  if (!row.examples.worst->beyond.empty()) json["worst"]["beyond"] = row.examples.worst->beyond;
  if (row.minimised.result) {
    json["case"] = row.minimised.case_file;
    json["size_found"] = json_of(row.minimised.size_before);
    json["size"] = json_of(oracle::size_of(row.minimised.result->scene));
    json["finding"] = oracle::json_of(row.minimised.result->finding);
    if (row.minimised.result->changed) json["changed"] = row.minimised.result->changed->how;
    if (!row.minimised.result->snippet.empty()) json["snippet"] = row.minimised.result->snippet;
  }
  return json;
}

Json json_of(const Cause& cause) {
  Json json = {{"subject", cause.subject->card.name},
               {"defect", oracle::name_of(shown_finding(*cause.rows[0]).defect)}};
  for (const Row* row : cause.rows) json["rows"].push_back(row->property->id);
  return json;
}

Json cards(const Ledger& ledger) {
  Json all = Json::array();
  for (const TestedSubject& subject : ledger.subjects) all.push_back(oracle::protocol::json_of(subject.card));
  return all;
}

Json properties_of(const Ledger& ledger) {
  Json all = Json::array();
  for (const properties::Property* property : ledger.results.tested_properties()) {
    all.push_back(
        {{"id", property->id}, {"query", property->query}, {"clauses", property->clauses}, {"says", property->says}});
  }
  return all;
}

}  // namespace

Json report_json(const Ledger& ledger) {
  Json json = {{"touchstone", "report/1"},
               {"version", version},
               {"seed", ledger.seed},
               {"effort", ledger.effort},
               {"cases_per_query", ledger.cases},
               {"interrupted", ledger.interrupted},
               {"subjects", cards(ledger)},
               {"properties", properties_of(ledger)}};
  json["rows"] = Json::array();
  for (const Row& row : ledger.results.all()) json["rows"].push_back(json_of(row));
  json["beyond"] = Json::array();  // rows outside the domain that a subject's card declares
  for (const Row& row : ledger.beyond.all()) {
    if (row.answered() > 0) json["beyond"].push_back(json_of(row));
  }
  json["causes"] = Json::array();
  for (const Cause& cause : causes(ledger)) json["causes"].push_back(json_of(cause));
  json["scenes"] = ledger.scenes;
  json["classes"] = ledger.classes;
  json["empty_classes"] = ledger.empty_classes;
  json["meshes"] = {{"read", ledger.meshes.count},
                    {"left_out", ledger.meshes.left_out},
                    {"absent", ledger.meshes.absent},
                    {"scenes", ledger.meshes.scenes}};
  return json;
}

std::string text_of(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n'; }

}  // namespace touchstone::app
