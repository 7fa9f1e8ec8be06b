#include "app/units/unit.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/profile/timed_answers.h"
#include "app/system/interruption.h"
#include "app/trial/counted_hangs.h"
#include "app/trial/domain_watch.h"
#include "app/trial/subject_list.h"
#include "properties/judging/remembered_answers.h"
#include "properties/scenes/domain.h"

namespace touchstone::app {
namespace {

using properties::Property;

/// Each unit starts the subjects afresh, and one that runs in Node.js takes 0.4 to 1 s of CPU time to start: as long as
/// it takes for some hundred questions. So a unit grows with the run, until the start is a small part of it; more units
/// than `enough_units` serve more threads and shards. All three are choices.
constexpr std::size_t enough_units = 8;
constexpr std::size_t least_chunk = 24;
constexpr std::size_t largest_chunk = 400;

/// If a property throws, that is a fault of Touchstone: the error names the place, so that it can be reproduced.
oracle::Finding checked(const Question& question, const Scene& scene, const Property& property,
                        oracle::Subject& subject) try {
  return property.check(scene, subject);
} catch (const std::exception& error) {
  throw std::logic_error(property.id + " of " + subject.card().name + " on " + question.family + ' ' +
                         std::to_string(question.index) + ": " + error.what());
}

/// The subject threw, refused or crashed, or said what is no answer: garbage, NaN.
bool is_no_answer(const oracle::Finding& finding) {
  return finding.outcome == oracle::Outcome::breaks || finding.defect == oracle::Defect::not_finite;
}

/// One subject and one scene, under each property.
class SceneTrial {
 public:
  /// All must outlive this object. `hangs` counts the questions on which the subject hung.
  SceneTrial(const Question& question, const TestedSubject& tested, const int& hangs, UnitResult& result,
             Example& example)
      : question_(question), tested_(tested), hangs_(hangs), result_(result), example_(example) {}

  /// A property that is told only of a hang which another property met counts as not asked: one hang is one break. A
  /// scene without an answer is one failure too, of `.survives`, if that is asked; the others say nothing of the scene.
  void ask(const Property& property, oracle::Subject& subject) {
    Row& row = result_.results.at(property, tested_);
    if (hangs_ >= most_hangs) {
      ++row.counts.not_asked;
      return;
    }
    const int hangs_before = hangs_;
    DomainWatch watch(subject);
    example_.finding = checked(question_, example_.scene, property, watch);
    example_.beyond = watch.beyond();
    if (interrupted()) return;  // a query that was cancelled is no failure
    if (example_.finding.defect == oracle::Defect::hung) {
      if (hangs_ == hangs_before) {
        ++row.counts.not_asked;
        return;
      }
    } else if (is_no_answer(example_.finding)) {
      if (without_answer_) {
        ++row.counts.unanswered;
        return;
      }
      without_answer_ = asks_for_sense(property);
    }
    outcome_.add(example_.finding);
    if (example_.beyond.empty()) {
      row.count(example_);
    } else {
      ++row.counts.beyond;
      result_.beyond.at(property, tested_).count(example_);
    }
  }

  /// Of all properties together.
  const SceneOutcome& outcome() const { return outcome_; }

 private:
  const Question& question_;
  const TestedSubject& tested_;
  const int& hangs_;
  UnitResult& result_;
  Example& example_;
  SceneOutcome outcome_;
  bool without_answer_ = false;
};

/// A subject that computes exactly is slow, and would only repeat the truth: beside others it is asked few questions,
/// and for no trajectory, which takes it seconds.
std::size_t exact_questions(const TrialPlan& plan, const std::string& query) {
  if (plan.subjects.size() == 1) return std::numeric_limits<std::size_t>::max();
  return is_simulated(query) ? 0 : static_cast<std::size_t>(plan.effort.exact_cases);
}

/// `.survives` first: it is the property that counts a scene without an answer.
std::vector<const Property*> in_order_of_asking(const Question& question, const QueryTrial& query) {
  std::vector<const Property*> asked;
  std::ranges::copy_if(query.properties, std::back_inserter(asked),
                       [&](const Property* property) { return question.asked_under(*property); });
  std::stable_partition(asked.begin(), asked.end(), [](const Property* property) { return asks_for_sense(*property); });
  return asked;
}

/// Asks one subject under each property. After a hang, a property that would ask the same question again does not.
void ask_all(const Question& question, const QueryTrial& query, const TestedSubject& tested, oracle::Subject& itself,
             const std::vector<AtlasPlace>& places, UnitResult& result, Example& example) {
  const bool is_asked = question.number < query.exact_questions || tested.card.precision != oracle::Precision::exact;
  int& hangs = result.hangs[tested.index];
  const int hangs_before = hangs;
  SceneTrial trial(question, tested, hangs, result, example);
  TimedAnswers timed(itself, result.profile.times.answers[tested.index]);
  CountedHangs counted(timed, hangs);
  properties::RememberedAnswers remembered(counted);
  for (const Property* property : in_order_of_asking(question, query)) {
    if (!is_asked || (properties::asks_twice(*property) && hangs > hangs_before)) {
      ++result.results.at(*property, tested).counts.not_asked;
    } else {
      trial.ask(*property, remembered.asked_by(*property));
    }
  }
  add(result.profile.atlas[tested.index], places, trial.outcome());
}

}  // namespace

std::vector<QueryTrial> trials(const TrialPlan& plan, const MeshSet& meshes) {
  std::vector<QueryTrial> all;
  for (const Property& property : properties::all()) {
    if (std::ranges::find(plan.properties, property.id) == plan.properties.end()) continue;
    if (all.empty() || all.back().name != property.query) {
      all.push_back({property.query,
                     exact_questions(plan, property.query),
                     plan.profiled,
                     {},
                     Questions(property.query, plan.effort, plan.seed, meshes)});
    }
    all.back().properties.push_back(&property);
  }
  return all;
}

std::vector<Unit> units(const std::vector<QueryTrial>& trials) {
  std::vector<Unit> all;
  for (std::size_t s = 0; s < trials.size(); ++s) {
    const std::size_t questions = trials[s].questions.size();
    const std::size_t chunk = std::clamp((questions + enough_units - 1) / enough_units, least_chunk, largest_chunk);
    for (std::size_t begin = 0; begin < questions; begin += chunk) {
      all.push_back({s, begin, std::min(begin + chunk, questions)});
    }
  }
  return all;
}

UnitResult nothing_of(const QueryTrial& query, const TestedSubjects& tested) {
  return {ResultMatrix(query.properties, tested),
          ResultMatrix(query.properties, tested),
          {},
          {},
          0,
          std::vector<int>(tested.size()),
          QueryProfile(tested.size())};
}

bool any_failing(const UnitResult& result) { return std::ranges::any_of(result.results.all(), &Row::failing); }

UnitResult run_unit(const QueryTrial& query, const Unit& unit, const TestedSubjects& tested, const Subjects& subjects,
                    std::vector<int> hangs, bool first_failure) {
  UnitResult result = nothing_of(query, tested);
  result.hangs = std::move(hangs);
  for (const auto& subject : subjects) start_afresh(*subject);
  for (std::size_t q = unit.begin; q < unit.end && !interrupted(); ++q) {
    if (first_failure && any_failing(result)) break;
    const Question question = query.questions[q];
    Example example{question.family, question.index, question.scene(), {}, {}};
    const Scene& scene = example.scene;
    ++result.scenes;
    if (question.family.starts_with("mesh.")) ++result.mesh_scenes[question.family];
    if (question.counts_for_classes) {
      for (const std::string& name : properties::classes_of(scene, query.name)) ++result.classes[name];
    }
    std::vector<AtlasPlace> places;
    if (query.profiled) {
      result.profile.left_out.add(scene, query.name);
      result.profile.times.plans.measure(scene, query.name);
      places = places_of(scene, query.name);
    }
    for (const TestedSubject& subject : tested) {
      ask_all(question, query, subject, *subjects[subject.index], places, result, example);
    }
  }
  return result;
}

}  // namespace touchstone::app
