#include "app/trial/trial.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/system/file_names.h"
#include "app/system/interruption.h"
#include "app/system/progress.h"
#include "app/system/terminal.h"
#include "app/trial/counted_hangs.h"
#include "app/trial/domain_watch.h"
#include "app/trial/parallel.h"
#include "app/trial/query_lines.h"
#include "app/trial/questions.h"
#include "app/trial/remembered_answers.h"
#include "app/trial/smallest.h"
#include "app/trial/subject_list.h"
#include "app/trial/unanswered.h"
#include "model/input_error.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"

namespace touchstone::app {
namespace {

using properties::Property;
using Subjects = std::vector<std::unique_ptr<oracle::Subject>>;

/// Each unit starts the subjects afresh, and one that runs in Node.js takes 0.3 to 0.5 s of CPU time to start. So a
/// long run has at most this many units for each query: a choice, enough for as many threads.
constexpr std::size_t most_units = 40;
constexpr std::size_t least_chunk = 24;
constexpr std::chrono::seconds seconds_without_line{60};  ///< a shorter run says nothing on stderr

struct Unit {
  std::size_t query = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct QueryTrial {
  std::string name;
  bool asks_exact = true;  ///< also subjects that compute exactly
  std::vector<const Property*> properties;
  Questions questions;
};

/// What one unit found about the properties of its query.
struct UnitResult {
  ResultMatrix results;
  ResultMatrix beyond;  ///< as in the ledger
  std::map<std::string, long> classes;
  std::map<std::string, long> mesh_scenes;
  long scenes = 0;
  std::vector<int> hangs;  ///< by subject
};

using TestedSubjects = std::vector<TestedSubject>;

Subjects connect_all(const TrialPlan& plan) {
  Subjects subjects;
  for (const std::string& name : plan.subjects) subjects.push_back(connect(name, plan.limits));
  return subjects;
}

std::vector<QueryTrial> trials(const TrialPlan& plan, const MeshSet& meshes) {
  std::vector<QueryTrial> all;
  for (const Property& property : properties::all()) {
    if (std::ranges::find(plan.properties, property.id) == plan.properties.end()) continue;
    if (all.empty() || all.back().name != property.query) {
      const bool asks_exact = plan.exact_simulations || !is_simulated(property.query);
      all.push_back({property.query, asks_exact, {}, Questions(property.query, plan.effort, plan.seed, meshes)});
    }
    all.back().properties.push_back(&property);
  }
  return all;
}

std::vector<Unit> units(const std::vector<QueryTrial>& trials) {
  std::vector<Unit> all;
  for (std::size_t s = 0; s < trials.size(); ++s) {
    const std::size_t questions = trials[s].questions.size();
    const std::size_t chunk = std::max(least_chunk, (questions + most_units - 1) / most_units);
    for (std::size_t begin = 0; begin < questions; begin += chunk) {
      all.push_back({s, begin, std::min(begin + chunk, questions)});
    }
  }
  return all;
}

std::map<std::string, std::size_t> units_of_queries(const std::vector<QueryTrial>& trials,
                                                    const std::vector<Unit>& units) {
  std::map<std::string, std::size_t> counts;
  for (const Unit& unit : units) ++counts[trials[unit.query].name];
  return counts;
}

void print_unless_bars(const std::string& line) {
  if (!draws_bars()) complain("{}", line);
}

/// If a property throws, that is a fault of Touchstone: the error names the place, so that it can be reproduced.
oracle::Finding checked(const Question& question, const Scene& scene, const Property& property,
                        oracle::Subject& subject) try {
  return property.check(scene, subject);
} catch (const std::exception& error) {
  throw std::logic_error(property.id + " of " + subject.card().name + " on " + question.family + ' ' +
                         std::to_string(question.index) + ": " + error.what());
}

/// `row` and `beyond`: for the answers inside and outside the domain that the subject's card declares. `hangs` counts
/// the questions on which the subject hung. A property that is told only of a hang which another property met counts as
/// not asked: one hang is one break.
void ask(const Question& question, const Property& property, oracle::Subject& subject, const int& hangs, Row& row,
         Row& beyond, Example& example) {
  if (hangs >= most_hangs) {
    ++row.counts.not_asked;
    return;
  }
  const int hangs_before = hangs;
  DomainWatch watch(subject);
  example.finding = checked(question, example.scene, property, watch);
  example.beyond = watch.beyond();
  if (interrupted()) return;  // a query that was cancelled is no failure
  if (example.finding.defect == oracle::Defect::hung && hangs == hangs_before) {
    ++row.counts.not_asked;
  } else if (example.beyond.empty()) {
    row.count(example);
  } else {
    ++row.counts.beyond;
    beyond.count(example);
  }
}

UnitResult nothing_of(const QueryTrial& query, const TestedSubjects& tested) {
  return {ResultMatrix(query.properties, tested), ResultMatrix(query.properties, tested), {}, {}, 0,
          std::vector<int>(tested.size())};
}

bool any_failing(const UnitResult& result) { return std::ranges::any_of(result.results.all(), &Row::failing); }

/// Asks one subject under each property. After a hang, a property that would ask the same question again does not.
void ask_all(const Question& question, const QueryTrial& query, const TestedSubject& tested, oracle::Subject& itself,
             UnitResult& result, Example& example) {
  const bool is_asked = query.asks_exact || tested.card.precision != oracle::Precision::exact;
  int& hangs = result.hangs[tested.index];
  const int hangs_before = hangs;
  CountedHangs counted(itself, hangs);
  RememberedAnswers remembered(counted);
  for (const Property* property : query.properties) {
    if (!question.asked_under(*property)) continue;
    Row& row = result.results.at(*property, tested);
    if (!is_asked || (asks_twice(*property) && hangs > hangs_before)) {
      ++row.counts.not_asked;
    } else {
      ask(question, *property, remembered.asked_by(*property), hangs, row, result.beyond.at(*property, tested),
          example);
    }
  }
}

/// `hangs`: by subject, how many count against it at the start of the unit.
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
    for (const TestedSubject& subject : tested) {
      ask_all(question, query, subject, *subjects[subject.index], result, example);
    }
  }
  return result;
}

void refuse_equal_names(const std::vector<oracle::Card>& cards) {
  std::set<std::string> names;
  for (const oracle::Card& card : cards) {
    if (!names.insert(card.name).second) {
      throw InputError("subjects",
                       "two of them call themselves " + card.name + ": the report could not tell them apart");
    }
  }
}

TestedSubjects tested_subjects(const TrialPlan& plan, const Subjects& subjects) {
  std::vector<oracle::Card> cards;
  for (const auto& subject : subjects) cards.push_back(subject->card());
  refuse_equal_names(cards);
  const std::vector<std::string> file_names = names_of_files(cards);
  TestedSubjects tested;
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    tested.push_back({s, cards[s], plan.subjects[s], file_names[s]});
  }
  return tested;
}

ResultMatrix::Properties properties_of(const std::vector<QueryTrial>& trials) {
  ResultMatrix::Properties all;
  for (const QueryTrial& query : trials) all.insert(all.end(), query.properties.begin(), query.properties.end());
  return all;
}

Ledger opened(const TrialPlan& plan, const MeshSet& meshes, const Subjects& subjects,
              const std::vector<QueryTrial>& trials) {
  Ledger ledger(properties_of(trials), tested_subjects(plan, subjects));
  ledger.seed = plan.seed;
  ledger.effort = plan.effort.name;
  ledger.cases = plan.effort.cases;
  ledger.meshes.absent = meshes.absent;
  ledger.meshes.count = meshes.meshes.size();
  ledger.meshes.left_out = meshes.left_out.size();
  return ledger;
}

void enter(Ledger& ledger, const QueryTrial& query, const UnitResult& result) {
  ledger.results.merge(result.results);
  ledger.beyond.merge(result.beyond);
  for (const auto& [name, count] : result.classes) ledger.classes[query.name][name] += count;
  for (const auto& [family, count] : result.mesh_scenes) ledger.meshes.scenes[family] += count;
  ledger.scenes[query.name] += result.scenes;
}

/// Merges units in order, whichever ends first, so the ledger does not depend on the threads. At most as many units
/// wait as threads are at work. If the run ends with the first failure, units after that of the failure do not count.
/// The same holds for a subject in the units of a query after one in which it hung `most_hangs` times.
class Entry {
 public:
  Entry(Ledger& ledger, const std::vector<QueryTrial>& trials, const std::vector<Unit>& units, bool first_failure)
      : ledger_(ledger),
        trials_(trials),
        units_(units),
        first_failure_(first_failure),
        given_up_(trials.size(), std::vector<bool>(ledger.subjects.size())) {}

  void add(std::size_t unit, UnitResult result) {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(unit, std::move(result));
    for (auto it = waiting_.begin(); it != waiting_.end() && it->first == next_; it = waiting_.erase(it), ++next_) {
      if (!ended_) merge(units_[next_].query, it->second);
    }
  }

  /// By subject: `most_hangs` if it is known by now that it is not asked any more in this unit, else 0. An earlier unit
  /// tells that as soon as it ends, also while it waits to be merged.
  std::vector<int> hangs(std::size_t unit) {
    const std::lock_guard lock(mutex_);
    const std::size_t query = units_[unit].query;
    std::vector<int> all;
    for (const TestedSubject& subject : ledger_.subjects) {
      const bool waits = std::any_of(waiting_.begin(), waiting_.lower_bound(unit), [&](const auto& earlier) {
        return units_[earlier.first].query == query && earlier.second.hangs[subject.index] >= most_hangs;
      });
      all.push_back(waits || given_up_[query][subject.index] ? most_hangs : 0);
    }
    return all;
  }

  bool ended() const { return ended_; }

 private:
  void merge(std::size_t query, UnitResult& result) {
    for (const TestedSubject& subject : ledger_.subjects) {
      if (given_up_[query][subject.index]) {
        result.results.forget(subject);
        result.beyond.forget(subject);
      }
      if (result.hangs[subject.index] >= most_hangs) given_up_[query][subject.index] = true;
    }
    ended_ = first_failure_ && any_failing(result);
    enter(ledger_, trials_[query], result);
  }

  Ledger& ledger_;
  const std::vector<QueryTrial>& trials_;
  const std::vector<Unit>& units_;
  bool first_failure_;
  std::vector<std::vector<bool>> given_up_;  // by query and subject
  std::atomic<bool> ended_ = false;
  std::mutex mutex_;
  std::map<std::size_t, UnitResult> waiting_;
  std::size_t next_ = 0;
};

void name_empty_classes(Ledger& ledger, const std::vector<QueryTrial>& trials) {
  for (const QueryTrial& query : trials) {
    for (const properties::Class& wanted : properties::classes(query.name)) {
      long& count = ledger.classes[query.name][wanted.name];
      if (count == 0) ledger.empty_classes.push_back(query.name + ": " + wanted.name);
    }
  }
}

}  // namespace

Ledger run(const TrialPlan& plan, const MeshSet& meshes) {
  const std::vector<QueryTrial> all_trials = trials(plan, meshes);
  const std::vector<Unit> all_units = units(all_trials);
  std::vector<Subjects> workers;  // one per job
  for (int job = 0; job < plan.jobs; ++job) workers.push_back(connect_all(plan));
  Ledger ledger = opened(plan, meshes, workers[0], all_trials);

  {
    Entry entry(ledger, all_trials, all_units, plan.first_failure);
    Progress progress("asking", static_cast<int>(all_units.size()));
    QueryLines lines(units_of_queries(all_trials, all_units), seconds_without_line, print_unless_bars);
    in_parallel(all_units.size(), plan.jobs, [&](std::size_t u, std::size_t job) {
      const QueryTrial& query = all_trials[all_units[u].query];
      UnitResult result = interrupted() || entry.ended() ? nothing_of(query, ledger.subjects)
                                                         : run_unit(query, all_units[u], ledger.subjects, workers[job],
                                                                    entry.hangs(u), plan.first_failure);
      const long scenes = result.scenes;
      entry.add(u, std::move(result));
      progress.step(query.name);
      lines.step(query.name, scenes);
    });
  }
  if (!plan.first_failure) name_empty_classes(ledger, all_trials);
  count_as_abstentions(ledger.results);
  count_as_abstentions(ledger.beyond);
  cut_down(ledger, workers, plan.first_failure ? Effort{} : plan.effort);
  ledger.interrupted = interrupted();
  return ledger;
}

}  // namespace touchstone::app
