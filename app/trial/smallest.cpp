#include "app/trial/smallest.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "app/report/replay_command.h"
#include "app/system/interruption.h"
#include "app/system/progress.h"
#include "app/trial/domain_watch.h"
#include "app/trial/effort.h"
#include "app/trial/fault_size.h"
#include "app/trial/last_asked.h"
#include "app/trial/parallel.h"
#include "app/trial/subject_list.h"
#include "model/input_error.h"
#include "oracle/judge/grade.h"
#include "oracle/judge/judge.h"
#include "properties/transforms/name.h"

namespace touchstone::app {
namespace {

using oracle::Defect;
using oracle::Finding;

/// Reduces the budget: a crash costs a new process, a hang the whole time limit.
int affordable(int budget, Defect defect) {
  if (defect == Defect::hung) return budget / 25;
  if (defect == Defect::crashed) return budget / 2;
  return budget;
}

oracle::Case with_note(oracle::Case a_case, const std::string& note) {
  a_case.note = note;
  return a_case;
}

/// The property, for which a scene that the subject in this process, or the truth, refuses as bad input is outside.
Finding checked(const properties::Property& property, const Scene& scene, oracle::Subject& subject) {
  try {
    return property.check(scene, subject);
  } catch (const InputError& refusal) {
    return oracle::judge::outside(refusal.what());
  }
}

/// The same defect in the same unit, and none of its sizes has sunk: the smallest scene must not be one where the fault
/// is next to nothing.
bool shows_the_same(const Finding& finding, const Scene& scene, const Example& original, oracle::Precision precision) {
  const Finding& found = original.finding;
  if (!failed(finding) || finding.defect != found.defect || finding.unit != found.unit) return false;
  if (oracle::grade(finding) < oracle::grade(found)) return false;
  if (!is_measurable(found, precision)) return true;
  return is_measurable(finding, precision) &&
         as_large(fault_size(finding, scene, precision), fault_size(found, original.scene, precision));
}

/// The scene that the last question was about, if it is another one than the case's own.
std::optional<oracle::ChangedScene> changed_scene(const Scene& scene, const LastAsked& asked) {
  if (!asked.scene() || *asked.scene() == scene) return std::nullopt;
  return oracle::ChangedScene{properties::name_of_change(scene, *asked.scene()), *asked.scene()};
}

/// Prints what the property expects beside the engine's answer. Empty if the subject has none.
std::string snippet_of(oracle::Subject& subject, const std::string& query, const Scene& scene,
                       const std::string& expected) {
  const Answer<std::string> said = subject.reproduce(query, scene, expected);
  const std::string* snippet = std::get_if<std::string>(&said);
  return snippet == nullptr ? "" : *snippet;
}

oracle::Case smallest_without_snippet(const Example& example, const properties::Property& property,
                                      oracle::Subject& subject, std::uint64_t seed, const Search& search) {
  oracle::Case result{property.id,   subject.card().name, example.family,  seed,
                      example.index, example.scene,       example.finding, ""};
  const oracle::Case interrupted_at_once = with_note(result, "interrupted: not reduced");
  if (interrupted()) return interrupted_at_once;
  start_afresh(subject);
  const oracle::Precision precision = subject.card().precision;
  int hangs = 0;
  const auto still_fails = [&](const Scene& scene) {
    if (interrupted() || hangs >= search.hangs) return false;
    DomainWatch watch(subject);
    const Finding finding = checked(property, scene, watch);
    if (finding.defect == Defect::hung) ++hangs;
    if (search.asked) search.asked();
    if (interrupted() || watch.beyond().empty() != example.beyond.empty()) return false;
    if (!shows_the_same(finding, scene, example, precision)) return false;
    result.finding = finding;
    return true;
  };
  result.scene = oracle::minimise(example.scene, still_fails, affordable(search.budget, example.finding.defect));
  if (!interrupted() && hangs >= search.hangs) {
    return with_note(result, fmt::format("not reduced further after {} hangs: a smaller scene may hang too", hangs));
  }
  const oracle::Case as_far_as_it_came = with_note(result, "interrupted: a smaller scene may fail too");
  start_afresh(subject);
  LastAsked last_asked(subject);
  result.finding = property.check(result.scene, last_asked);
  if (interrupted()) return as_far_as_it_came;
  if (shows_the_same(result.finding, result.scene, example, precision)) {
    result.changed = changed_scene(result.scene, last_asked);
    return result;
  }
  start_afresh(subject);
  result.scene = example.scene;
  result.finding = property.check(result.scene, last_asked);
  if (interrupted()) return interrupted_at_once;
  result.note = failed(result.finding) ? "not reduced: the smaller scene fails only after other questions"
                                       : "fails only after other questions: the finding is the one of the run";
  if (failed(result.finding)) {
    result.changed = changed_scene(result.scene, last_asked);
  } else {
    result.finding = example.finding;
  }
  return result;
}

/// A choice: half of the failing rows of a report are outside what engines declare.
constexpr int part_for_what_does_not_count = 8;

/// The rows that would be minimised as hangs, except the first of each subject.
std::set<const Row*> hang_like_another(const std::vector<Row*>& failing) {
  std::set<const Row*> all;
  std::set<const TestedSubject*> seen;
  for (const Row* row : failing) {
    if (row->examples.smallest->finding.defect == Defect::hung && !seen.insert(row->subject).second) all.insert(row);
  }
  return all;
}

std::string case_file_of(const Row& row) {
  const bool inside = row.examples.smallest->beyond.empty();
  return "cases/" + row.property->id + "." + row.subject->file_name + (inside ? "" : ".beyond") + ".json";
}

oracle::Case as_found(const Row& row, std::uint64_t seed) {
  const Example& found = *row.examples.smallest;
  return {row.property->id, {},          found.family,  seed,
          found.index,      found.scene, found.finding, "not reduced: it hangs like another row"};
}

}  // namespace

oracle::Case smallest_case(const Example& example, const properties::Property& property, oracle::Subject& subject,
                           std::uint64_t seed, const Search& search) {
  oracle::Case result = smallest_without_snippet(example, property, subject, seed, search);
  if (interrupted()) return result;
  const auto program_for = [&](const Scene& scene) {
    return snippet_of(subject, property.query, scene, result.finding.expected);
  };
  result.snippet = program_for(result.scene);
  if (result.changed) result.changed->snippet = program_for(result.changed->scene);
  return result;
}

void cut_down(Ledger& ledger, const std::vector<std::vector<std::unique_ptr<oracle::Subject>>>& workers,
              const Effort& effort) {
  std::vector<Row*> failing;
  for (ResultMatrix* results : {&ledger.results, &ledger.beyond}) {
    for (Row& row : results->all()) {
      if (row.failing()) failing.push_back(&row);
    }
  }
  const std::set<const Row*> alike = hang_like_another(failing);
  Progress progress("reducing", static_cast<int>(failing.size()));
  in_parallel(failing.size(), static_cast<int>(workers.size()), [&](std::size_t f, std::size_t job) {
    Row& row = *failing[f];
    const TestedSubject& subject = *row.subject;
    const int whole = is_simulated(row.property->query) ? effort.trajectories.minimise_budget : effort.minimise_budget;
    const int budget = row.examples.smallest->beyond.empty() ? whole : whole / part_for_what_does_not_count;
    row.minimised.size_before = oracle::size_of(row.examples.smallest->scene);
    row.minimised.result = alike.contains(&row)
                               ? as_found(row, ledger.seed)
                               : smallest_case(*row.examples.smallest, *row.property, *workers[job][subject.index],
                                               ledger.seed, {budget, most_hangs});
    row.minimised.result->subject = subject.connectable;
    row.minimised.result->folder = folder_of(subject.connectable);
    row.minimised.case_file = case_file_of(row);
    progress.step(row.property->id + " of " + subject.card.name);
  });
}

}  // namespace touchstone::app
