// Fuzzing finds subjects that are wrong on purpose, accuses none that is right, and repeats itself.
#include "app/fuzz/fuzz_run.h"

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "oracle/judge/judge.h"
#include "oracle/passing_on.h"
#include "oracle/subject.h"
#include "oracle/subjects/canaries/canaries.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/reference.h"
#include "oracle/tolerance/tolerance.h"
#include "tests/app/changed_distances.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

using tests::ChangedDistances;

FuzzPlan plan_of(const std::string& query, long executions) {
  FuzzPlan plan;
  plan.query = query;
  for (const properties::Property& property : properties::all()) {
    if (property.query == query) plan.properties.push_back(&property);
  }
  plan.executions = executions;
  plan.draws = 1;
  plan.minimise_budget = 100;
  return plan;
}

FuzzResult fuzz_canary(const std::string& query, const std::string& id, long executions) {
  const auto subject = oracle::subjects::canary(id).make(oracle::subjects::make_reference());
  return fuzz(plan_of(query, executions), *subject);
}

TEST_CASE("A subject that is wrong on purpose is found, with a case that still fails") {
  for (const auto& [query, id] : {std::pair("distance", "canary.near_means_touching"),
                                  {"distance", "canary.gives_up"},
                                  {"mass", "canary.inertia_of_box"},
                                  {"bounds", "canary.box_one_ulp_inward"},
                                  {"penetration", "canary.face_normals_only"}}) {
    INFO(query << ' ' << id);
    const FuzzResult result = fuzz_canary(query, id, 300);
    REQUIRE(!result.findings.empty());
    const FuzzFinding& finding = result.findings.front();
    CHECK(finding.execution <= 300);
    const auto again = oracle::subjects::canary(id).make(oracle::subjects::make_reference());
    CHECK(failed(finding.row.property->check(finding.smallest.scene, *again)));
  }
}

TEST_CASE("A subject that is right is not accused") {
  for (const char* query : {"distance", "mass", "bounds", "broad_phase", "penetration"}) {
    INFO(query);
    CHECK(fuzz(plan_of(query, 300), *oracle::subjects::make_reference()).findings.empty());
  }
  for (const char* query : {"distance", "mass", "bounds", "broad_phase"}) {
    INFO(query);
    CHECK(fuzz(plan_of(query, 300), *oracle::subjects::make_fast()).findings.empty());
  }
}

TEST_CASE("The screen alone leads to a wrong answer, and does not contradict the properties") {
  const auto planted = [](const ChangedDistances::Change& change) {
    const auto fast = oracle::subjects::make_fast();
    ChangedDistances subject(*fast, change);
    FuzzPlan plan = plan_of("distance", 400);
    plan.share = 1 << 30;  // no scene is drawn: the screen, or something new, leads to the properties
    return fuzz(plan, subject);
  };
  const FuzzResult right = planted([](const Scene&, Distance&) {});
  CHECK(right.findings.empty());
  CHECK(right.contradictions.empty());
  CHECK(right.judged < right.executions);

  const FuzzResult wrong = planted([](const Scene& scene, Distance& said) {
    const bool is_far = scene.bodies[0].X_WB.p_WB.lpNorm<1>() > scene.bodies[1].X_WB.p_WB.lpNorm<1>();
    if (is_far && said.verdict == Verdict::separated) *said.distance += 0x1p-40 * oracle::tolerance::scale(scene);
  });
  REQUIRE(!wrong.findings.empty());
  CHECK(wrong.contradictions.empty());
}

/// Fuzzes distances under properties with the usual names, which all say the same.
FuzzResult fuzz_under(const oracle::Finding& finding, oracle::Subject& subject) {
  FuzzPlan plan = plan_of("distance", 40);
  std::vector<properties::Property> changed;
  for (const properties::Property* property : plan.properties) {
    changed.push_back(*property);
    changed.back().check = [&finding](const Scene&, oracle::Subject&) { return finding; };
  }
  for (std::size_t p = 0; p < changed.size(); ++p) plan.properties[p] = &changed[p];
  return fuzz(plan, subject);
}

TEST_CASE("A contradiction between the screen and the properties is reported") {
  const auto fast = oracle::subjects::make_fast();
  ChangedDistances wrong(*fast, [](const Scene& scene, Distance& said) {
    if (said.verdict == Verdict::separated) *said.distance += oracle::tolerance::scale(scene);
  });
  const FuzzResult accused = fuzz_under(oracle::judge::holds(), wrong);
  REQUIRE(accused.contradictions.size() == 1);
  CHECK(accused.contradictions[0].what == "the screen calls an answer wrong, and no property fails");

  const FuzzResult cleared = fuzz_under(oracle::judge::wrong(oracle::Defect::too_far, "2", "1"), *fast);
  REQUIRE(cleared.contradictions.size() == 1);
  CHECK(cleared.contradictions[0].what == "distance.verdict fails of an answer that the screen calls right");
}

TEST_CASE("Without all properties that the screen stands for, every scene is asked under those of the plan") {
  FuzzPlan plan = plan_of("distance", 50);
  plan.properties.resize(2);
  const FuzzResult result = fuzz(plan, *oracle::subjects::make_fast());
  CHECK(result.judged == 50);
  CHECK(result.verdicts == 100);
}

TEST_CASE("The same plan has the same result") {
  const FuzzResult one = fuzz_canary("distance", "canary.near_means_touching", 200);
  const FuzzResult two = fuzz_canary("distance", "canary.near_means_touching", 200);
  CHECK(one.coverage.signals == two.coverage.signals);
  CHECK(one.coverage.kept == two.coverage.kept);
  CHECK(one.judged == two.judged);
  CHECK(one.verdicts == two.verdicts);
  REQUIRE(one.findings.size() == two.findings.size());
  for (std::size_t f = 0; f < one.findings.size(); ++f) CHECK(one.findings[f].smallest == two.findings[f].smallest);
}

TEST_CASE("Marks of fast are counted, and other subjects have none") {
  const FuzzResult fast = fuzz(plan_of("distance", 100), *oracle::subjects::make_fast());
  CHECK(std::ranges::any_of(fast.coverage.marks, [](std::uint64_t count) { return count > 0; }));
  const FuzzResult exact = fuzz(plan_of("distance", 100), *oracle::subjects::make_reference());
  CHECK(std::ranges::all_of(exact.coverage.marks, [](std::uint64_t count) { return count == 0; }));
}

class Throwing final : public oracle::PassingOn<Throwing> {
 public:
  using PassingOn::PassingOn;

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*)(const Scene&), const Scene& scene) {
    throw std::runtime_error("vertex " + std::to_string(scene.bodies.size()) + " is lost");
  }
};

TEST_CASE("An exception is a finding, and once for all properties and numbers in its words") {
  const auto reference = oracle::subjects::make_reference();
  Throwing subject(*reference);
  FuzzPlan plan = plan_of("bounds", 60);
  plan.minimise_budget = 20;
  const FuzzResult result = fuzz(plan, subject);
  REQUIRE(result.findings.size() == 1);
  CHECK(result.findings[0].smallest.finding.defect == oracle::Defect::threw);
  CHECK(result.findings[0].execution == 1);
}

}  // namespace
}  // namespace touchstone::app
