#include "app/units/unit_json.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "app/baseline/named_value.h"
#include "model/json_node.h"
#include "oracle/case.h"

namespace touchstone::app {
namespace {

using oracle::Defect;
using oracle::Grade;

/// In the order in which they are written.
std::array<long*, 10> numbers_of(Counts& counts) {
  return {&counts.holds,   &counts.fails,     &counts.abstains,   &counts.breaks, &counts.refused,
          &counts.outside, &counts.not_asked, &counts.unanswered, &counts.beyond, &counts.impacts};
}

Json json_of(const Example& example) {
  Json json = {{"family", example.family}, {"index", example.index}, {"finding", oracle::json_of(example.finding)}};
  if (!example.beyond.empty()) json["beyond"] = example.beyond;
  return json;
}

Json json_of(const ErrorHistogram& errors) {
  Json powers = Json::object();
  for (const auto& [power, count] : errors.powers) powers[std::to_string(power)] = count;
  return {{"unit", errors.unit},
          {"exact", errors.exact},
          {"powers", std::move(powers)},
          {"infinite", errors.infinite},
          {"largest", oracle::json_of_number(errors.largest)}};
}

Json json_of(const Row& row) {
  Json json = {{"property", row.property->id}, {"subject", row.subject->index}};
  Counts counts = row.counts;
  for (const long* number : numbers_of(counts)) json["counts"].push_back(*number);
  if (row.answered() > 0) json["grades"] = row.grades;
  for (const auto& [defect, count] : row.defects) {
    json["defects"].push_back({oracle::name_of(defect), count, oracle::name_of(row.worst_grades.at(defect))});
  }
  if (!row.why_abstains.empty()) json["why_abstains"] = row.why_abstains;
  if (!row.largest_error.unit.empty()) {
    json["largest_error"] = {oracle::json_of_number(row.largest_error.size), row.largest_error.unit};
  }
  if (!row.errors.unit.empty()) json["errors"] = json_of(row.errors);
  if (row.examples.closest) json["closest"] = json_of(*row.examples.closest);
  if (row.examples.worst) json["worst"] = json_of(*row.examples.worst);
  if (row.examples.smallest) json["smallest"] = json_of(*row.examples.smallest);
  return json;
}

/// An array for each cell: subject, axis, class, scenes, failing, broken, largest error over what is allowed.
Json json_of(const std::vector<Atlas>& by_subject) {
  Json cells = Json::array();
  for (std::size_t s = 0; s < by_subject.size(); ++s) {
    for (const auto& [place, cell] : by_subject[s]) {
      cells.push_back(
          {s, place.first, place.second, cell.scenes, cell.failing, cell.broken, oracle::json_of_number(cell.excess)});
    }
  }
  return cells;
}

Json json_of(const LeftOut& left_out) {
  Json parts = Json::object();
  for (const auto& [what, part] : left_out.parts) parts[what] = {part.scenes, part.why};
  return {{"planned", left_out.planned}, {"kept", left_out.kept}, {"parts", std::move(parts)}};
}

Json json_of(const ResultMatrix& results) {
  Json rows = Json::array();
  for (const Row& row : results.all()) {
    Counts counts = row.counts;
    const auto numbers = numbers_of(counts);
    if (std::ranges::any_of(numbers, [](const long* number) { return *number != 0; })) rows.push_back(json_of(row));
  }
  return rows;
}

/// The scenes of a unit, by the family and the index of their draws. Each is drawn at most once: many rows show it.
class UnitScenes {
 public:
  UnitScenes(const QueryTrial& query, const Unit& unit) {
    for (std::size_t q = unit.begin; q < unit.end; ++q) {
      Question question = query.questions[q];
      questions_.try_emplace({question.family, question.index}, std::move(question));
    }
  }

  /// Null if the unit has no such scene.
  const Scene* find(const std::string& family, std::uint64_t index) {
    const auto question = questions_.find({family, index});
    if (question == questions_.end()) return nullptr;
    const auto [drawn, is_new] = drawn_.try_emplace(question->first);
    if (is_new) drawn->second = question->second.scene();
    return &drawn->second;
  }

 private:
  using Draw = std::pair<std::string, std::uint64_t>;

  std::map<Draw, Question> questions_;
  std::map<Draw, Scene> drawn_;
};

std::optional<Example> read_example(const Json& row, const Node& node, const char* key, UnitScenes& scenes) {
  const std::optional<Node> found = node.find(key);
  if (!found) return {};
  const Json& json = row.at(key);
  Example example;
  example.family = found->at("family").text();
  example.index = static_cast<std::uint64_t>(found->at("index").number());
  found->at("finding");
  example.finding = oracle::read_finding(json.at("finding"), std::string(key) + ".finding");
  if (const auto beyond = found->find("beyond")) example.beyond = beyond->text();
  const Scene* scene = scenes.find(example.family, example.index);
  if (scene == nullptr) found->refuse("the unit has no scene of this family and index");
  example.scene = *scene;
  return example;
}

ErrorHistogram read_errors(const Json& json, const Node& node) {
  ErrorHistogram errors;
  errors.unit = node.at("unit").text();
  errors.exact = node.at("exact").index();
  errors.infinite = node.at("infinite").index();
  errors.largest = oracle::read_number(json.at("largest"), node.at("largest"));
  const Node powers = node.at("powers");
  for (const auto& [power, count] : json.at("powers").items())
    errors.powers[std::stoi(power)] = powers.at(power).index();
  return errors;
}

void read_row(const Json& json, const Node& node, UnitScenes& scenes, Row& row) {
  const Node counts = node.at("counts");
  const auto numbers = numbers_of(row.counts);
  counts.expect_size(static_cast<int>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) *numbers[i] = counts[static_cast<int>(i)].index();
  if (const auto grades = node.find("grades")) {
    grades->expect_size(static_cast<int>(row.grades.size()));
    for (std::size_t g = 0; g < row.grades.size(); ++g) row.grades[g] = (*grades)[static_cast<int>(g)].index();
  }
  if (const auto defects = node.find("defects")) {
    for (int d = 0; d < defects->size(); ++d) {
      const Node entry = (*defects)[d];
      entry.expect_size(3);
      const Defect defect = read_named(entry[0], Defect::none, Defect::garbage);
      row.defects[defect] = entry[1].index();
      row.worst_grades[defect] = read_named(entry[2], Grade::A, Grade::F);
    }
  }
  if (const auto why = node.find("why_abstains")) row.why_abstains = why->text();
  if (const auto largest = node.find("largest_error")) {
    largest->expect_size(2);
    row.largest_error = {oracle::read_number(json.at("largest_error")[0], (*largest)[0]), (*largest)[1].text()};
  }
  if (const auto errors = node.find("errors")) row.errors = read_errors(json.at("errors"), *errors);
  row.examples = {read_example(json, node, "closest", scenes), read_example(json, node, "worst", scenes),
                  read_example(json, node, "smallest", scenes)};
}

void read_results(const Json& json, const Node& node, const QueryTrial& query, UnitScenes& scenes,
                  const TestedSubjects& tested, ResultMatrix& results) {
  for (int r = 0; r < node.size(); ++r) {
    const Node row = node[r];
    const std::string id = row.at("property").text();
    const auto property = std::ranges::find(query.properties, id, &properties::Property::id);
    if (property == query.properties.end()) row.at("property").refuse("is no property of " + query.name);
    const auto subject = static_cast<std::size_t>(row.at("subject").index());
    if (subject >= tested.size()) row.at("subject").refuse("there is no such subject");
    read_row(json[static_cast<std::size_t>(r)], row, scenes, results.at(**property, tested[subject]));
  }
}

std::vector<Atlas> read_atlas(const Json& json, const Node& node, std::size_t subjects) {
  std::vector<Atlas> by_subject(subjects);
  for (int c = 0; c < node.size(); ++c) {
    const Node entry = node[c];
    entry.expect_size(7);
    const auto subject = static_cast<std::size_t>(entry[0].index());
    if (subject >= subjects) entry[0].refuse("there is no such subject");
    const auto axis = static_cast<std::size_t>(entry[1].index());
    if (axis >= atlas_axes().size()) entry[1].refuse("there is no such axis");
    const auto k = static_cast<std::size_t>(entry[2].index());
    if (k > atlas_axes()[axis].edges.size()) entry[2].refuse("the axis has no such class");
    by_subject[subject][{static_cast<int>(axis), static_cast<int>(k)}] = {
        entry[3].index(), entry[4].index(), entry[5].index(),
        oracle::read_number(json[static_cast<std::size_t>(c)][6], entry[6])};
  }
  return by_subject;
}

LeftOut read_left_out(const Json& json, const Node& node) {
  LeftOut left_out;
  left_out.planned = node.at("planned").index();
  left_out.kept = node.at("kept").index();
  const Node parts = node.at("parts");
  for (const auto& [what, part] : json.at("parts").items()) {
    const Node entry = parts.at(what);
    entry.expect_size(2);
    left_out.parts[what] = {entry[0].index(), entry[1].text()};
  }
  return left_out;
}

std::map<std::string, long> read_counts(const Json& json, const Node& node) {
  std::map<std::string, long> counts;
  for (const auto& [name, count] : json.items()) counts[name] = node.at(name).index();
  return counts;
}

}  // namespace

Json json_of(const UnitResult& result) {
  Json classes = Json::object(), mesh_scenes = Json::object();
  for (const auto& [name, count] : result.classes) classes[name] = count;
  for (const auto& [family, count] : result.mesh_scenes) mesh_scenes[family] = count;
  return {{"scenes", result.scenes},
          {"classes", std::move(classes)},
          {"mesh_scenes", std::move(mesh_scenes)},
          {"hangs", result.hangs},
          {"results", json_of(result.results)},
          {"beyond", json_of(result.beyond)},
          {"atlas", json_of(result.profile.atlas)},
          {"left_out", json_of(result.profile.left_out)}};
}

UnitResult read_unit(const Json& json, const QueryTrial& query, const Unit& unit, const TestedSubjects& tested,
                     const std::string& place) {
  const Node node(json, place);
  UnitResult result = nothing_of(query, tested);
  result.scenes = node.at("scenes").index();
  const Node classes = node.at("classes"), meshes = node.at("mesh_scenes"), hangs = node.at("hangs");
  result.classes = read_counts(json.at("classes"), classes);
  result.mesh_scenes = read_counts(json.at("mesh_scenes"), meshes);
  hangs.expect_size(static_cast<int>(tested.size()));
  for (std::size_t s = 0; s < tested.size(); ++s) result.hangs[s] = hangs[static_cast<int>(s)].index();
  UnitScenes scenes(query, unit);
  const Node results = node.at("results"), beyond = node.at("beyond");
  read_results(json.at("results"), results, query, scenes, tested, result.results);
  read_results(json.at("beyond"), beyond, query, scenes, tested, result.beyond);
  const Node atlas = node.at("atlas"), left_out = node.at("left_out");
  result.profile.atlas = read_atlas(json.at("atlas"), atlas, tested.size());
  result.profile.left_out = read_left_out(json.at("left_out"), left_out);
  return result;
}

}  // namespace touchstone::app
