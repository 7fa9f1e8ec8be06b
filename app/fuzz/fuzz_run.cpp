#include "app/fuzz/fuzz_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <set>
#include <utility>

#include "app/fuzz/enlarge.h"
#include "app/fuzz/pool.h"
#include "app/fuzz/screen.h"
#include "app/fuzz/signals.h"
#include "app/fuzz/starting_scenes.h"
#include "app/system/interruption.h"
#include "app/system/progress.h"
#include "app/trial/causes.h"
#include "app/trial/domain_watch.h"
#include "app/trial/effort.h"
#include "app/trial/smallest.h"
#include "model/input_error.h"
#include "oracle/judge/judge.h"
#include "oracle/query.h"
#include "properties/fuzzing/displace.h"
#include "properties/fuzzing/mutate.h"
#include "properties/judging/remembered_answers.h"
#include "properties/random.h"

namespace touchstone::app {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::judge::Screened;
using properties::Property;
using properties::Random;

constexpr int most_mutations = 5;  ///< of one execution; a choice

/// The property, for which an exception is a break too. A scene that subject or truth refuses as bad input is outside.
Property guarded(const Property& property) {
  Property same = property;
  same.check = [check = property.check](const Scene& scene, oracle::Subject& subject) -> Finding {
    try {
      return check(scene, subject);
    } catch (const InputError& refusal) {
      return oracle::judge::outside(refusal.what());
    } catch (const std::exception& error) {
      return oracle::judge::broken(Breaks{Breaks::Kind::threw, error.what()});
    }
  };
  return same;
}

std::string cause_of(const Property& property, const Finding& finding) {
  const std::string defect = name_of(finding.defect);
  return finding.outcome == oracle::Outcome::breaks ? defect + ' ' + without_numbers(finding.why)
                                                    : property.id + ' ' + defect;
}

/// The time or the number of executions until the end.
class End {
 public:
  explicit End(const FuzzPlan& plan)
      : plan_(plan),
        progress_("fuzzing " + plan.query, plan.executions ? static_cast<int>(*plan.executions) : whole_seconds()) {}

  bool reached(long executions) const {
    return interrupted() || (plan_.executions && executions >= *plan_.executions) ||
           (plan_.seconds && seconds() >= *plan_.seconds);
  }

  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  void show(long executions, std::size_t findings) {
    const int done =
        plan_.executions ? static_cast<int>(executions) : std::min(static_cast<int>(seconds()), whole_seconds());
    if (done == shown_) return;
    progress_.step(fmt::format("{} executions, {} findings", executions, findings), done - shown_);
    shown_ = done;
  }

 private:
  int whole_seconds() const { return static_cast<int>(plan_.seconds.value_or(0)); }

  const FuzzPlan& plan_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  int shown_ = 0;
  Progress progress_;
};

/// A scene, and after it scenes with the same shapes elsewhere.
class Neighbours {
 public:
  const Scene& scene() const { return scene_; }

  void begin(Scene scene, int neighbours) {
    scene_ = std::move(scene);
    left_ = neighbours;
    keep();
  }

  /// Makes the next scene; returns false if there is none.
  bool displace(Random& random) {
    if (left_ == 0) return false;
    --left_;
    properties::fuzzing::displace(scene_, random);
    return true;
  }

  /// The next scenes begin at this one if it was kept, else at the one before.
  void end(bool is_kept) {
    if (is_kept) return keep();
    for (std::size_t b = 0; b < places_.size(); ++b) scene_.bodies[b].X_WB = places_[b];
  }

 private:
  void keep() {
    places_.clear();
    for (const Body& body : scene_.bodies) places_.push_back(body.X_WB);
  }

  Scene scene_;
  std::vector<Pose> places_;
  int left_ = 0;
};

class Fuzzer {
 public:
  Fuzzer(const FuzzPlan& plan, oracle::Subject& subject)
      : plan_(plan),
        subject_(subject),
        query_(*oracle::find_query(plan.query)),
        is_screened_(Screen::applies(plan.query, plan.properties)),
        screen_(subject) {
    for (const Property* property : plan.properties) {
      properties_.push_back(guarded(*property));
      result_.holding.emplace_back();
      result_.holding.back().property = property;
    }
    result_.card = subject.card();
  }

  FuzzResult run() {
    execute_all();
    cut_down();
    if (plan_.enlarge_budget > 0) enlarge();
    result_.coverage.kept = pool_.size();
    result_.coverage.signals = seen_.size();
    result_.interrupted = interrupted();
    return std::move(result_);
  }

 private:
  void execute_all() {
    const std::vector<Scene> starts = starting_scenes(plan_.query, plan_.seed, plan_.draws);
    const fast::MarkCounts marks_before = fast::mark_counts;
    End end(plan_);
    while (!end.reached(result_.executions) && !(plan_.first_failure && has_finding())) {
      const auto n = static_cast<std::uint64_t>(result_.executions++);
      Random random(plan_.seed, "fuzz " + plan_.query, n);
      if (n < starts.size()) {
        execute(starts[n], true, random);
      } else {
        execute_next(random);
      }
      end.show(result_.executions, result_.findings.size());
    }
    result_.seconds = end.seconds();
    result_.coverage.marks = fast::marks_since(marks_before);
  }

  bool has_finding() const { return !result_.findings.empty() || !result_.contradictions.empty(); }

  Scene next(Random& random) {
    Scene scene = pool_.choose(random);
    int mutations = 1;
    while (mutations < most_mutations && random.one_in(2)) ++mutations;
    for (; mutations > 0; --mutations) {
      const Scene& other = pool_.choose(random);
      scene = properties::fuzzing::mutated(scene, other, query_, random);
    }
    return scene;
  }

  /// A mutated scene, or a neighbour of the last one: of what a mutation costs, most is for new shapes.
  void execute_next(Random& random) {
    if (!neighbours_.displace(random)) neighbours_.begin(next(random), is_screened_ ? plan_.neighbours : 0);
    neighbours_.end(execute(neighbours_.scene(), false, random));
  }

  /// Was the scene kept?
  bool execute(const Scene& scene, bool is_start, Random& random) {
    Screen::Seen seen;
    if (is_screened_) {
      seen = screen_.ask(scene);
      const bool is_drawn = random.one_in(plan_.share);
      if (seen.result == Screened::right && !seen.is_new && !is_start && !is_drawn) return false;
    }
    return ask_all(scene, seen, is_start, random);
  }

  bool ask_all(const Scene& scene, const Screen::Seen& seen, bool is_start, Random& random) {
    ++result_.judged;
    Signals signals;
    const fast::MarkCounts marks_before = fast::mark_counts;
    const Judged judged = judge(scene, signals);
    compare(scene, seen.result, judged);
    signals.add_marks(marks_before, fast::mark_counts);
    signals.add_scene(scene, plan_.query);
    bool is_new = seen.is_new;
    for (const std::string& word : signals.words()) is_new |= seen_.insert(word).second;
    const bool is_kept = is_start || (is_new && judged.all_answered);
    if (is_kept) pool_.keep(scene, signals.nearness(), random);
    return is_kept;
  }

  /// What the properties said that the screen stands for.
  struct Judged {
    bool all_answered = true;  ///< of all properties: the subject ended its answers
    std::string failed;        ///< the first that failed; empty: none
    bool is_outside = false;   ///< one of them had nothing to say, or the scene is beyond the card's domain
  };

  void compare(const Scene& scene, Screened screened, const Judged& judged) {
    if (!is_screened_ || !judged.all_answered) return;
    if (screened == Screened::right && !judged.failed.empty()) {
      contradict(scene, judged.failed + " fails of an answer that the screen calls right");
    }
    if (screened == Screened::wrong && judged.failed.empty() && !judged.is_outside) {
      contradict(scene, "the screen calls an answer wrong, and no property fails");
    }
  }

  void contradict(const Scene& scene, std::string what) {
    const auto is_known = [&](const Contradiction& known) { return known.what == what; };
    if (std::ranges::any_of(result_.contradictions, is_known)) return;
    result_.contradictions.push_back({result_.executions, std::move(what), scene});
  }

  Judged judge(const Scene& scene, Signals& signals) {
    properties::RememberedAnswers remembered(subject_);
    Judged judged;
    Example example{"", static_cast<std::uint64_t>(result_.executions), scene, {}, {}};
    for (std::size_t p = 0; p < properties_.size(); ++p) {
      DomainWatch watch(remembered.asked_by(properties_[p]));
      example.finding = properties_[p].check(scene, watch);
      if (interrupted()) {
        judged.all_answered = false;
        return judged;
      }
      ++result_.verdicts;
      if (!watch.beyond().empty()) {
        judged.is_outside = true;
        ++result_.beyond;
        continue;
      }
      signals.add_finding(properties_[p], example.finding);
      if (failed(example.finding)) {
        count_failure(p, example);
      } else {
        result_.holding[p].count(example);
      }
      if (Screen::stands_for(properties_[p])) note(example.finding, properties_[p].id, judged);
      if (example.finding.defect == Defect::hung) {
        judged.all_answered = false;
        return judged;
      }
    }
    return judged;
  }

  static void note(const Finding& finding, const std::string& id, Judged& judged) {
    if (failed(finding) && judged.failed.empty()) judged.failed = id;
    judged.is_outside |= finding.outcome == oracle::Outcome::outside && id == "distance.verdict";
  }

  void count_failure(std::size_t property, const Example& example) {
    const std::string cause = cause_of(properties_[property], example.finding);
    const auto [known, is_new] = causes_.try_emplace(cause, result_.findings.size());
    if (is_new) {
      result_.findings.push_back({result_.executions, {}, {}});
      result_.findings.back().row.property = plan_.properties[property];
    }
    Row& row = result_.findings[known->second].row;
    if (row.property == plan_.properties[property]) row.count(example);
  }

  void cut_down() {
    Progress progress("reducing", static_cast<int>(result_.findings.size()));
    for (FuzzFinding& finding : result_.findings) {
      const Example& example = *finding.row.examples.smallest;
      finding.smallest = smallest_case(example, guarded(*finding.row.property), subject_, plan_.seed,
                                       {.budget = plan_.minimise_budget, .hangs = most_hangs});
      if (finding.smallest.note.empty()) {
        finding.smallest.note = fmt::format("touchstone fuzz {}, seed {}: execution {}, made smaller", plan_.query,
                                            plan_.seed, example.index);
      }
      progress.step(finding.row.property->id);
    }
  }

  void enlarge() {
    Progress progress("enlarging", static_cast<int>(result_.findings.size()));
    for (FuzzFinding& finding : result_.findings) {
      const Example& worst = *finding.row.examples.worst;
      const bool has_size =
          worst.finding.outcome == oracle::Outcome::fails && worst.finding.unit != oracle::without_size;
      if (has_size && !interrupted()) {
        finding.largest = enlarged(worst, guarded(*finding.row.property), subject_, plan_.enlarge_budget);
      }
      progress.step(finding.row.property->id);
    }
  }

  const FuzzPlan& plan_;
  oracle::Subject& subject_;
  const oracle::Query& query_;
  std::vector<Property> properties_;
  const bool is_screened_;
  Screen screen_;
  Pool pool_;
  Neighbours neighbours_;
  std::set<std::string> seen_;
  std::map<std::string, std::size_t> causes_;  ///< to the index of the finding
  FuzzResult result_;
};

}  // namespace

FuzzResult fuzz(const FuzzPlan& plan, oracle::Subject& subject) { return Fuzzer(plan, subject).run(); }

}  // namespace touchstone::app
