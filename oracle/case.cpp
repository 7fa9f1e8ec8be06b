#include "oracle/case.h"

#include <cmath>
#include <limits>

#include "model/infinity.h"
#include "model/json_node.h"
#include "model/limits.h"
#include "model/source_text.h"

namespace touchstone::oracle {
namespace {

constexpr const char* case_format = "case/1";

/// Finds the value with this name; `last` is the greatest value of the enumeration.
template <class Name>
Name read_name(const Node& node, Name last) {
  const std::string word = node.text();
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    if (name_of(static_cast<Name>(i)) == word) return static_cast<Name>(i);
  }
  node.refuse("unknown name " + Json(word).dump());
}

void write_if_there(Json& json, const char* key, const std::string& text) {
  if (!text.empty()) json[key] = text;
}

void read_if_there(const Node& node, const char* key, std::string& text) {
  if (const auto found = node.find(key)) text = found->text();
}

/// Keeps all 64 bits, which Node::number, a double, cannot hold.
std::uint64_t read_uint64(const Json& json, const char* key, const Node& node) {
  const Node value = node.at(key);
  if (!json.at(key).is_number_unsigned())
    value.refuse("expected an integer from 0 to 2^64 - 1, found " + json.at(key).dump());
  return json.at(key).get<std::uint64_t>();
}

void validate_at(const Scene& scene, const std::string& place) {
  try {
    validate(scene);
  } catch (const InputError& error) {  // its message starts with the path within the scene
    throw InputError("", place + error.what());
  }
}

Case read_case_json(const Json& json, const std::string& place) {
  const Node node(json, place);
  if (const std::string format = node.at("touchstone").text(); format != case_format) {
    node.at("touchstone").refuse("expected \"" + std::string(case_format) + "\", found " + Json(format).dump());
  }
  node.expect_object({"touchstone", "property", "subject", "folder", "family", "seed", "index", "note", "finding",
                      "scene", "changed", "snippet"});
  Case a_case;
  a_case.property = node.at("property").text();
  read_if_there(node, "subject", a_case.subject);
  read_if_there(node, "folder", a_case.folder);
  read_if_there(node, "family", a_case.family);
  a_case.seed = read_uint64(json, "seed", node);
  a_case.index = read_uint64(json, "index", node);
  read_if_there(node, "note", a_case.note);
  read_if_there(node, "snippet", a_case.snippet);
  const std::string dot = place.empty() ? "" : ".";
  node.at("finding");
  a_case.finding = read_finding(json.at("finding"), place + dot + "finding");
  node.at("scene");
  a_case.scene = read<Scene>(json.at("scene"), place + dot + "scene");
  validate_at(a_case.scene, place + dot + "scene.");
  if (const auto changed = node.find("changed")) {
    changed->expect_object({"how", "scene", "snippet"});
    changed->at("scene");
    const std::string there = place + dot + "changed.scene";
    a_case.changed = {changed->at("how").text(), read<Scene>(json.at("changed").at("scene"), there)};
    read_if_there(*changed, "snippet", a_case.changed->snippet);
    validate_at(a_case.changed->scene, there + '.');
  }
  return a_case;
}

}  // namespace

Json json_of_number(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}

double read_number(const Json& json, const Node& node) {
  if (!json.is_string()) return node.number();
  const std::string word = json.get<std::string>();
  if (word == "inf") return infinity;
  if (word == "-inf") return -infinity;
  if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
  node.refuse("expected a number, \"inf\", \"-inf\" or \"nan\", found " + json.dump());
}

Json json_of(const Finding& finding) {
  Json json = {{"outcome", name_of(finding.outcome)}, {"defect", name_of(finding.defect)}};
  write_if_there(json, "observed", finding.observed);
  write_if_there(json, "expected", finding.expected);
  json["error"] = json_of_number(finding.error);
  json["allowed"] = json_of_number(finding.allowed);
  write_if_there(json, "unit", finding.unit);
  if (finding.rounding != 0) json["rounding"] = json_of_number(finding.rounding);
  if (finding.relative) json["relative"] = json_of_number(*finding.relative);
  if (finding.of_body) json["of_body"] = json_of_number(*finding.of_body);
  if (finding.margin) json["margin"] = {json_of_number(finding.margin->lo), json_of_number(finding.margin->hi)};
  write_if_there(json, "certificate", finding.certificate);
  write_if_there(json, "why", finding.why);
  return json;
}

Finding read_finding(const Json& json, const std::string& place) {
  const Node node(json, place);
  node.expect_object({"outcome", "defect", "observed", "expected", "error", "allowed", "unit", "rounding", "relative",
                      "of_body", "margin", "certificate", "why"});
  Finding finding;
  finding.outcome = read_name(node.at("outcome"), Outcome::outside);
  finding.defect = read_name(node.at("defect"), Defect::garbage);
  read_if_there(node, "observed", finding.observed);
  read_if_there(node, "expected", finding.expected);
  const Node error = node.at("error");
  finding.error = read_number(json.at("error"), error);
  const Node allowed = node.at("allowed");
  finding.allowed = read_number(json.at("allowed"), allowed);
  read_if_there(node, "unit", finding.unit);
  if (const auto rounding = node.find("rounding")) finding.rounding = read_number(json.at("rounding"), *rounding);
  if (const auto relative = node.find("relative")) finding.relative = read_number(json.at("relative"), *relative);
  if (const auto of_body = node.find("of_body")) finding.of_body = read_number(json.at("of_body"), *of_body);
  if (const auto margin = node.find("margin")) {
    margin->expect_size(2);
    finding.margin = {read_number(json.at("margin")[0], (*margin)[0]), read_number(json.at("margin")[1], (*margin)[1])};
  }
  read_if_there(node, "certificate", finding.certificate);
  read_if_there(node, "why", finding.why);
  return finding;
}

Json json_of(const Case& a_case) {
  Json json = {{"touchstone", case_format}, {"property", a_case.property}};
  write_if_there(json, "subject", a_case.subject);
  write_if_there(json, "folder", a_case.folder);
  write_if_there(json, "family", a_case.family);
  json["seed"] = a_case.seed;
  json["index"] = a_case.index;
  write_if_there(json, "note", a_case.note);
  json["finding"] = json_of(a_case.finding);
  json["scene"] = touchstone::json_of(a_case.scene);
  write_if_there(json, "snippet", a_case.snippet);
  if (a_case.changed) {
    json["changed"] = {{"how", a_case.changed->how}, {"scene", touchstone::json_of(a_case.changed->scene)}};
    write_if_there(json["changed"], "snippet", a_case.changed->snippet);
  }
  return json;
}

Case case_from(std::string_view text, const std::string& place) {
  return read_document(text, place, [](const Json& json) { return read_case_json(json, ""); });
}

Case read_case(const std::string& path) {
  const SourceText source = read_source(path);
  return case_from(source.text, source.name);
}

void write_case(const Case& a_case, const std::string& path) { write_text(path, text_of(json_of(a_case))); }

}  // namespace touchstone::oracle
