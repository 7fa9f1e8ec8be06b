#include "app/trial/trial.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "app/system/file_names.h"
#include "app/system/interruption.h"
#include "app/system/progress.h"
#include "app/system/terminal.h"
#include "app/trial/parallel.h"
#include "app/trial/query_lines.h"
#include "app/trial/smallest.h"
#include "app/trial/subject_list.h"
#include "app/trial/unanswered.h"
#include "app/units/unit.h"
#include "app/units/unit_json.h"
#include "model/input_error.h"
#include "model/json_node.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"

namespace touchstone::app {
namespace {

constexpr std::chrono::seconds seconds_without_line{60};  ///< a shorter run says nothing on stderr

Subjects connect_all(const TrialPlan& plan) {
  Subjects subjects;
  for (const std::string& name : plan.subjects) subjects.push_back(connect(name, plan.limits));
  return subjects;
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
  ledger.profiles[query.name].merge(result.profile);
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
        result.profile.atlas[subject.index].clear();
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

/// What remains to be done when all units are merged.
void finish(Ledger& ledger, const TrialPlan& plan, const std::vector<QueryTrial>& trials,
            const std::vector<Subjects>& workers) {
  if (!plan.first_failure) name_empty_classes(ledger, trials);
  count_as_abstentions(ledger.results);
  count_as_abstentions(ledger.beyond);
  cut_down(ledger, workers, plan.first_failure ? Effort{} : plan.effort);
  ledger.interrupted = interrupted();
}

std::vector<Subjects> workers_of(const TrialPlan& plan) {
  std::vector<Subjects> workers;  // one per job
  for (int job = 0; job < plan.jobs; ++job) workers.push_back(connect_all(plan));
  return workers;
}

/// Progress on stderr: a bar, or a line when a query is done.
class UnitProgress {
 public:
  UnitProgress(const std::vector<QueryTrial>& trials, const std::vector<Unit>& units)
      : bar_("asking", static_cast<int>(units.size())),
        lines_(units_of_queries(trials, units), seconds_without_line, print_unless_bars) {}

  void step(const std::string& query, long scenes) {
    bar_.step(query);
    lines_.step(query, scenes);
  }

 private:
  Progress bar_;
  QueryLines lines_;
};

}  // namespace

Ledger run(const TrialPlan& plan, const MeshSet& meshes) {
  const std::vector<QueryTrial> all_trials = trials(plan, meshes);
  const std::vector<Unit> all_units = units(all_trials);
  const std::vector<Subjects> workers = workers_of(plan);
  Ledger ledger = opened(plan, meshes, workers[0], all_trials);
  {
    Entry entry(ledger, all_trials, all_units, plan.first_failure);
    UnitProgress progress(all_trials, all_units);
    in_parallel(all_units.size(), plan.jobs, [&](std::size_t u, std::size_t job) {
      const QueryTrial& query = all_trials[all_units[u].query];
      UnitResult result = interrupted() || entry.ended() ? nothing_of(query, ledger.subjects)
                                                         : run_unit(query, all_units[u], ledger.subjects, workers[job],
                                                                    entry.hangs(u), plan.first_failure);
      const long scenes = result.scenes;
      entry.add(u, std::move(result));
      progress.step(query.name, scenes);
    });
  }
  finish(ledger, plan, all_trials, workers);
  return ledger;
}

ShardResult run_shard(const TrialPlan& plan, const MeshSet& meshes, Shard shard) {
  const std::vector<QueryTrial> all_trials = trials(plan, meshes);
  const std::vector<Unit> all_units = units(all_trials);
  const std::vector<Subjects> workers = workers_of(plan);
  const TestedSubjects tested = tested_subjects(plan, workers[0]);
  std::vector<std::size_t> mine;
  std::vector<Unit> mine_of_all;
  for (std::size_t u = static_cast<std::size_t>(shard.number - 1); u < all_units.size();
       u += static_cast<std::size_t>(shard.of)) {
    mine.push_back(u);
    mine_of_all.push_back(all_units[u]);
  }
  ShardResult result;
  for (const TestedSubject& subject : tested) result.versions.push_back(subject.card.name + ' ' + subject.card.version);
  result.units.resize(mine.size());
  UnitProgress progress(all_trials, mine_of_all);
  std::mutex merging;
  in_parallel(mine.size(), plan.jobs, [&](std::size_t m, std::size_t job) {
    const QueryTrial& query = all_trials[mine_of_all[m].query];
    if (interrupted()) return;
    const UnitResult unit =
        run_unit(query, mine_of_all[m], tested, workers[job], std::vector<int>(tested.size()), false);
    result.units[m] = {{"unit", mine[m]}};
    result.units[m].update(json_of(unit));
    const std::lock_guard lock(merging);
    result.times[query.name].merge(unit.profile.times);
    progress.step(query.name, unit.scenes);
  });
  return result;
}

Ledger merged(const TrialPlan& plan, const MeshSet& meshes, const std::vector<ShardResult>& shards) {
  const std::vector<QueryTrial> all_trials = trials(plan, meshes);
  const std::vector<Unit> all_units = units(all_trials);
  const std::vector<Subjects> workers = workers_of(plan);
  Ledger ledger = opened(plan, meshes, workers[0], all_trials);
  std::vector<const Json*> found(all_units.size());
  const std::string of_a_unit = "shard";
  for (const ShardResult& shard : shards) {
    for (const Json& unit : shard.units) {
      const Node node(unit, of_a_unit);
      const Node number = node.at("unit");
      const auto u = static_cast<std::size_t>(number.index());
      if (u >= found.size() || found[u] != nullptr) number.refuse("this unit does not exist, or is there twice");
      found[u] = &unit;
    }
  }
  Entry entry(ledger, all_trials, all_units, false);
  for (std::size_t u = 0; u < all_units.size(); ++u) {
    const std::string place = "unit " + std::to_string(u);
    if (found[u] == nullptr) throw InputError(place, "is in no shard");
    const QueryTrial& query = all_trials[all_units[u].query];
    entry.add(u, read_unit(*found[u], query, all_units[u], ledger.subjects, place));
  }
  for (const ShardResult& shard : shards) {
    for (const auto& [query, times] : shard.times) {
      if (times.answers.size() != ledger.subjects.size()) throw InputError("times of a shard", "are of other subjects");
      ledger.profiles[query].times.merge(times);
    }
  }
  finish(ledger, plan, all_trials, workers);
  return ledger;
}

}  // namespace touchstone::app
