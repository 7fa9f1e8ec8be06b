#include "app/trial/questions.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "properties/queries.h"
#include "properties/scenes/domain.h"
#include "properties/scenes/extreme.h"

namespace touchstone::app {
namespace {

using properties::Family;
using properties::for_query;
using properties::Property;

/// The laws of impacts compare two answers, and other properties already check each of them.
bool compares_two_impacts(const Property& property) {
  static const std::vector<Property> laws = properties::impulse_law_properties();
  return std::ranges::find(laws, property.id, &Property::id) != laws.end();
}

/// The scenes after the first `cases` are only for the properties that need one answer.
bool for_the_first_cases_all(std::size_t number, std::size_t cases, const Property& property) {
  return number < cases || !compares_two_impacts(property);
}

/// No bound on rounding holds for an extreme scene. It only checks that the subject ends, makes sense and repeats
/// itself.
bool is_for_extreme_scenes(std::size_t, std::size_t, const Property& property) {
  return asks_for_sense(property) || property.id.ends_with(".repeats");
}

/// A scene without an answer has to be counted by `.survives`.
bool is_asked_of_each_mesh(const Property& property) {
  return compares_with_truth(property) || asks_for_sense(property);
}

std::vector<Question> about_meshes(const std::string& query, const Effort& effort, std::uint64_t seed,
                                   const MeshSet& set) {
  std::vector<Question> questions;
  const std::vector<MeshQuestion> asked = mesh_questions(query, effort, set);
  std::map<std::string, std::size_t> place;  // index of a law among the query's laws
  for (const Property& property : properties::all()) {
    if (property.query == query && !is_asked_of_each_mesh(property)) place.emplace(property.id, place.size());
  }
  const auto share = static_cast<std::size_t>(effort.mesh_share);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const MeshQuestion& question = asked[k];
    questions.push_back({question.family, question.index,
                         [&set, question, seed] { return mesh_scene(set, question, seed); },
                         [place, k, share](const Property& property) {
                           return is_asked_of_each_mesh(property) || place.at(property.id) % share == k % share;
                         },
                         false});
  }
  return questions;
}

std::size_t counted(int n) { return static_cast<std::size_t>(n); }

int cases_of(const std::string& query, const Effort& effort) {
  if (query == "simulation") return std::min(effort.cases, effort.trajectories.simulations);
  return query == "constraint" ? std::min(effort.cases, effort.trajectories.constraints) : effort.cases;
}

Question numbered(Question question, std::size_t number) {
  question.number = number;
  return question;
}

int extremes_of(const std::string& query, const Effort& effort) {
  return query == "simulation" ? std::min(effort.extreme_cases, effort.trajectories.extreme_cases)
                               : effort.extreme_cases;
}

}  // namespace

bool asks_for_sense(const Property& property) { return property.id.ends_with(".survives"); }

bool compares_with_truth(const Property& property) {
  static constexpr std::array endings = {".agrees", ".verdict", ".value", ".depth"};
  return std::ranges::any_of(endings, [&](const char* ending) { return property.id.ends_with(ending); });
}

DrawnQuestions::DrawnQuestions(std::vector<const Family*> families, std::size_t cases, std::size_t more,
                               std::uint64_t seed, bool counts_for_classes, AskedUnder asked_under)
    : families_(std::move(families)),
      cases_(cases),
      more_(more),
      seed_(seed),
      counts_for_classes_(counts_for_classes),
      asked_under_(asked_under) {}

Question DrawnQuestions::operator[](std::size_t k) const {
  const Family* family = families_[k % families_.size()];
  const std::uint64_t index = k / families_.size();
  return {family->id, index, [family, index, seed = seed_] { return draw(*family, seed, index); },
          [k, cases = cases_, asked_under = asked_under_](const Property& p) { return asked_under(k, cases, p); },
          counts_for_classes_};
}

Questions::Questions(const std::string& query, const Effort& effort, std::uint64_t seed, const MeshSet& set)
    : drawn_(for_query(properties::families(), query), counted(cases_of(query, effort)),
             query == "impulse" ? counted(effort.more_impacts) : 0, seed, true, for_the_first_cases_all),
      extreme_(for_query(properties::extremes(), query), counted(extremes_of(query, effort)), 0, seed, false,
               is_for_extreme_scenes),
      meshes_(about_meshes(query, effort, seed, set)) {}

Question Questions::operator[](std::size_t k) const {
  if (k < drawn_.size()) return numbered(drawn_[k], k);
  k -= drawn_.size();
  if (k < extreme_.size()) return numbered(extreme_[k], k);
  k -= extreme_.size();
  return numbered(meshes_[k], k);
}

}  // namespace touchstone::app
