#include "tests/properties/kills.h"

#include <algorithm>
#include <set>

#include "oracle/judge/grade.h"
#include "oracle/subjects/canaries/canaries.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/reference.h"
#include "properties/clause.h"
#include "properties/property.h"
#include "tests/properties/scenes.h"

namespace touchstone::tests {
namespace {

// Computes each answer that costs the reference milliseconds only once.
template <class T, class Ask>
Answer<T> asked_once(const Scene& scene, Ask&& ask) {
  static std::vector<std::pair<Scene, Answer<T>>> asked;
  const auto found = std::ranges::find(asked, scene, &std::pair<Scene, Answer<T>>::first);
  if (found != asked.end()) return found->second;
  return asked.emplace_back(scene, ask(scene)).second;
}

// The reference with remembered answers, since it is slow where the slip direction changes and for motions. It follows
// one ball among fixed boxes alone by constraints: `fast` follows the others.
class Truthful : public oracle::Subject {
 public:
  const oracle::Card& card() const override { return reference_->card(); }
  Answer<Masses> mass(const Scene& scene) override { return reference_->mass(scene); }
  Answer<Bounds> bounds(const Scene& scene) override { return reference_->bounds(scene); }
  Answer<PairSet> broad_phase(const Scene& scene) override { return reference_->broad_phase(scene); }
  Answer<PairHistory> pair_history(const Scene& scene) override { return reference_->pair_history(scene); }
  Answer<Distance> distance(const Scene& scene) override { return reference_->distance(scene); }
  Answer<Penetration> penetration(const Scene& scene) override { return reference_->penetration(scene); }
  Answer<Pixels> pixel(const Scene& scene) override { return reference_->pixel(scene); }
  Answer<Impulse> impulse(const Scene& scene) override {
    return asked_once<Impulse>(scene, [&](const Scene& s) { return reference_->impulse(s); });
  }
  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override {
    return asked_once<TimeOfImpact>(scene, [&](const Scene& s) { return reference_->time_of_impact(s); });
  }
  Answer<Trajectory> simulation(const Scene& scene) override {
    return asked_once<Trajectory>(scene, [&](const Scene& s) { return reference_->simulation(s); });
  }
  Answer<Trajectory> constraint(const Scene& scene) override {
    return asked_once<Trajectory>(scene, [&](const Scene& s) {
      const Answer<Trajectory> exact = reference_->constraint(s);
      return std::holds_alternative<Abstains>(exact) ? fast_->constraint(s) : exact;
    });
  }

 private:
  const std::unique_ptr<oracle::Subject> reference_ = oracle::subjects::make_reference();
  const std::unique_ptr<oracle::Subject> fast_ = oracle::subjects::make_fast();
};

// `fast`, which notes whether it is asked about another simulation than the one given.
class Asked : public oracle::Subject {
 public:
  explicit Asked(const Scene& given) : given_(given) {}
  const oracle::Card& card() const override { return fast_->card(); }
  Answer<Trajectory> simulation(const Scene& scene) override {
    about_another_ = about_another_ || scene != given_;
    return fast_->simulation(scene);
  }
  bool about_another() const { return about_another_; }

 private:
  const Scene& given_;
  const std::unique_ptr<oracle::Subject> fast_ = oracle::subjects::make_fast();
  bool about_another_ = false;
};

// Does it ask about scenes that are made from the one given, and perhaps from what the subject says of it?
bool makes_simulations(const properties::Property& property) {
  return property.query == "simulation" && std::ranges::any_of(scenes_of(property.query), [&](const Scene& scene) {
           Asked subject(scene);
           property.check(scene, subject);
           return subject.about_another();
         });
}

// The properties of a query ask that query; those of broad_phase also ask pair_history, for sequences.
bool lies_about(const oracle::subjects::Canary& canary, const std::string& query) {
  return std::ranges::any_of(canary.lies_about, [&](const std::string& lie) {
    return lie == query || (lie == "pair_history" && query == "broad_phase");
  });
}

// Makes a new canary for each scene, since its memory is part of its lie.
oracle::Finding judged(const properties::Property& property, const oracle::subjects::Canary& canary, const Scene& scene,
                       bool quickly) {
  const auto subject = canary.make(quickly ? oracle::subjects::make_fast() : truthful());
  return property.check(scene, *subject);
}

std::string verdict(const oracle::Finding& finding) {
  return name_of(finding.defect) + ", " + oracle::name_of(oracle::grade(finding));
}

std::string list(const auto& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "`" : ", `") + name + "`";
  return all;
}

/// "wrong_value, D: `canary.a`, `canary.b`; threw, F: `canary.throws`"
std::string by_verdict(const std::map<std::string, std::string>& caught) {
  std::map<std::string, std::vector<std::string>> canaries;
  for (const auto& [canary, verdict] : caught) canaries[verdict].push_back(canary);
  std::string all;
  for (const auto& [verdict, names] : canaries) all += (all.empty() ? "" : "; ") + verdict + ": " + list(names);
  return all;
}

}  // namespace

std::unique_ptr<oracle::Subject> truthful() { return std::make_unique<Truthful>(); }

const std::map<std::string, std::map<std::string, std::string>>& kills() {
  static const std::map<std::string, std::map<std::string, std::string>> table = [] {
    std::map<std::string, std::map<std::string, std::string>> found;
    // The reference takes 0.1 s for a simulation, and each lie makes simulations of its own: `fast` answers these. It
    // keeps the same properties on these scenes (canary_test.cpp).
    std::set<std::string> quickly;
    for (const properties::Property& property : properties::all()) {
      found[property.id];
      if (makes_simulations(property)) quickly.insert(property.id);
    }
    // Each scene is asked of all in turn, since the judge keeps the truth about the last one.
    for (const std::string& query : properties::tested_queries()) {
      for (const Scene& scene : scenes_of(query)) {
        for (const properties::Property& property : properties::all()) {
          if (property.query != query) continue;
          std::map<std::string, std::string>& caught = found[property.id];
          for (const auto& canary : oracle::subjects::canaries()) {
            if (caught.contains(canary.id) || !lies_about(canary, query)) continue;
            const oracle::Finding finding = judged(property, canary, scene, quickly.contains(property.id));
            if (failed(finding)) caught.emplace(canary.id, verdict(finding));
          }
        }
      }
    }
    return found;
  }();
  return table;
}

std::string kill_table() {
  std::string page =
      "# Canaries\n\n"
      "A canary is a deliberately wrong subject. Each property must catch at least one, and each canary must be "
      "caught. Made by\n"
      "`tests/properties/canary_test.cpp` from runs, on a few scenes by hand, over a truthful subject that tells one "
      "lie. The\n"
      "verdict, a defect and a grade, is that on the first scene that shows the lie. To make it anew: "
      "`TOUCHSTONE_UPDATE=1\n"
      "./touchstone test -R \"canaries' page\"`.\n\n"
      "| property | catches |\n|---|---|\n";
  for (const properties::Property& property : properties::all()) {
    page += "| `" + property.id + "` | " + by_verdict(kills().at(property.id)) + " |\n";
  }
  page += "\n| canary | its lie |\n|---|---|\n";
  for (const auto& canary : oracle::subjects::canaries()) page += "| `" + canary.id + "` | " + canary.says + " |\n";
  return page;
}

std::string clause_index() {
  std::string page =
      "# Clauses\n\n"
      "Every numbered sentence of the specification, with the properties that check it and the canaries that prove "
      "them sharp.\n"
      "Made by `tests/properties/trace_test.cpp`. To make it anew: `TOUCHSTONE_UPDATE=1 ./touchstone test -R "
      "\"clauses' page\"`.\n\n"
      "| clause | title | checked by | proved sharp by |\n|---|---|---|---|\n";
  for (const properties::Clause& clause : properties::clauses()) {
    page += "| [" + clause.id + "](" + clause.query + ".md) | " + clause.title + " | " + list(clause.checked_by) +
            " | " + list(clause.sharp_by) + " |\n";
  }
  return page;
}

}  // namespace touchstone::tests
