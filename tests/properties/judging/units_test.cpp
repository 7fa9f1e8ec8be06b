// What a property allows is a number of ulps, so it does not depend on the units in which a scene is written. An
// allowance with a factor too few or too many, as 2T in place of √(2T), is unnoticed in scenes of about 1 kg, 1 m and
// 1 s.
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "properties/judging/remembered_answers.h"
#include "properties/property.h"
#include "properties/transforms/motion.h"
#include "properties/transforms/scene.h"
#include "tests/catch.h"
#include "tests/properties/kills.h"
#include "tests/properties/scenes.h"

using namespace touchstone;

namespace {

/// The scene with lengths times 2^l, masses times 2^(3l + m) and times by 2^-t; none if a number of it overflows or
/// underflows.
std::optional<Scene> in_units(Scene scene, int l, int m, int t) {
  const bool moves = scene.motion.has_value();
  if (!moves) scene.motion.emplace();
  std::optional<Scene> other = properties::scaled(std::move(scene), l);  // at the same density
  if (other) other = properties::heavier(*other, m);
  if (other) other = properties::hastened(*other, t);
  if (other && !moves) other->motion.reset();
  return other;
}

std::string text(const oracle::Finding& finding) {
  return name_of(finding.outcome) + " " + std::to_string(finding.allowed) + " " + finding.unit + " " + finding.why;
}

// Engines that step may end slip up to 1/256 s early or late, in every scene.
const std::set<std::string> allow_for_steps = {"simulation.carried", "constraint.carried", "constraint.turns"};

bool is_about(double a, double b) { return a == b || std::abs(a - b) <= 1e-6 * b; }

bool alike(const oracle::Finding& a, const oracle::Finding& b) {
  const bool in_ulps = a.unit.rfind("ulps", 0) == 0;
  return a.outcome == b.outcome && a.unit == b.unit && a.why == b.why && (!in_ulps || is_about(a.allowed, b.allowed));
}

// The reference takes 10 to 15 s for each of these.
bool is_slow(const Scene& scene) {
  return scene.name == "balls that rub" || scene.name.find("within the envelope") != std::string::npos;
}

/// Of each scene all properties are asked, since the judge keeps what it knows about the last one.
std::vector<oracle::Finding> findings(const std::vector<const properties::Property*>& asked, const Scene& scene,
                                      oracle::Subject& subject) {
  properties::RememberedAnswers answers(subject);
  std::vector<oracle::Finding> all;
  for (const properties::Property* property : asked) all.push_back(property->check(scene, answers.asked_by(*property)));
  return all;
}

void compare(const std::vector<const properties::Property*>& asked, int time_scale) {
  const auto subject = tests::truthful();
  for (const Scene& scene : tests::scenes_of(asked.front()->query)) {
    const std::optional<Scene> other = in_units(scene, 12, 17, time_scale);
    if (!other || is_slow(scene)) continue;
    const std::vector<oracle::Finding> here = findings(asked, scene, *subject);
    const std::vector<oracle::Finding> there = findings(asked, *other, *subject);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      INFO(asked[i]->id << " of " << scene.name << ": " << text(here[i]) << "; in other units " << text(there[i]));
      CHECK(alike(here[i], there[i]));
    }
  }
}

}  // namespace

TEST_CASE("What a property allows, in ulps, does not depend on the units of a scene") {
  for (const std::string& query : properties::tested_queries()) {
    std::vector<const properties::Property*> of_steps, others;
    for (const properties::Property& property : properties::all()) {
      if (property.query == query) (allow_for_steps.contains(property.id) ? of_steps : others).push_back(&property);
    }
    compare(others, 7);
    if (!of_steps.empty()) compare(of_steps, 0);
  }
}
