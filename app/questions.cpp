#include "app/questions.h"

#include <algorithm>
#include <map>

#include "properties/domain.h"
#include "properties/extreme.h"

namespace touchstone::app {
namespace {

using properties::Family;
using properties::Property;

bool any_property(const Property&) { return true; }

/// No bound on rounding holds for an extreme scene; that the subject ends, makes sense and repeats itself does.
bool asks_only_for_sense(const Property& property) {
  return property.id.ends_with(".survives") || property.id.ends_with(".repeats");
}

std::vector<const Family*> for_stem(const std::vector<Family>& families, const std::string& stem) {
  std::vector<const Family*> chosen;
  for (const Family& family : families) {
    if (std::ranges::find(family.stems, stem) != family.stems.end()) chosen.push_back(&family);
  }
  return chosen;
}

/// Question k is draw k/F of family k mod F: each family gets its share whatever the count.
void add_drawn(std::vector<Question>& questions, const std::vector<const Family*>& families, int count,
               std::uint64_t seed, bool counts_for_classes, bool (*asked_under)(const Property&)) {
  if (families.empty()) return;
  for (int k = 0; k < count; ++k) {
    const Family* family = families[static_cast<std::size_t>(k) % families.size()];
    const std::uint64_t index = static_cast<std::size_t>(k) / families.size();
    questions.push_back({family->id, index, [family, seed, index] { return draw(*family, seed, index); }, asked_under,
                         counts_for_classes});
  }
}

void add_meshes(std::vector<Question>& questions, const std::string& stem, const Effort& effort, std::uint64_t seed,
                const MeshSet& set) {
  const std::vector<MeshQuestion> asked = mesh_questions(stem, effort, set);
  std::map<std::string, std::size_t> place;  // of a law among the stem's
  for (const Property& property : properties::all()) {
    if (property.stem == stem && !compares_with_truth(property)) place.emplace(property.id, place.size());
  }
  const auto share = static_cast<std::size_t>(effort.mesh_share);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const MeshQuestion& question = asked[k];
    questions.push_back({question.family, question.index,
                         [&set, question, seed] { return mesh_scene(set, question, seed); },
                         [place, k, share](const Property& property) {
                           return compares_with_truth(property) || place.at(property.id) % share == k % share;
                         },
                         false});
  }
}

}  // namespace

bool compares_with_truth(const Property& property) {
  return property.id.ends_with(".verdict") || property.id.ends_with(".value") || property.id.ends_with(".depth");
}

std::vector<Question> questions(const std::string& stem, const Effort& effort, std::uint64_t seed, const MeshSet& set) {
  std::vector<Question> all;
  const int cases = stem == "impulse" ? std::min(effort.cases, effort.impacts) : effort.cases;
  add_drawn(all, for_stem(properties::families(), stem), cases, seed, true, any_property);
  add_drawn(all, for_stem(properties::extremes(), stem), effort.extreme_cases, seed, false, asks_only_for_sense);
  add_meshes(all, stem, effort, seed, set);
  return all;
}

}  // namespace touchstone::app
