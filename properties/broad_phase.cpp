// The clauses of docs/spec/broad_phase.md about single scenes as executable properties.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "model/sequence.h"
#include "oracle/judge/words.h"
#include "oracle/truth/truth.h"
#include "properties/cases/pair_sets.h"
#include "properties/judging/asking.h"
#include "properties/judging/declared_boxes.h"
#include "properties/judging/missed_pairs.h"
#include "properties/queries.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;
namespace truth = oracle::truth;
namespace words = oracle::words;

// Sequences have properties of their own (properties/broad_phase_sequences.cpp).
template <class Ask>
Finding of_still(const Scene& scene, const Subject& subject, Ask&& ask) {
  if (is_sequence(scene)) return judge::outside("a scene with frames");
  return of_scene(scene, subject, std::forward<Ask>(ask));
}

template <class JudgeIt>
Finding of_pairs(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return of_still(scene, subject, [&] { return judge::given(subject.broad_phase(scene), judge_it); });
}

reference::Rational gap(const Scene& scene, const Pair& pair) {
  const std::vector<reference::ExactBox>& boxes = truth::bounds(scene);
  if (pair.first == pair.second) return {};
  return reference::gap(boxes[static_cast<std::size_t>(pair.first)], boxes[static_cast<std::size_t>(pair.second)]);
}

// A pair whose exact boxes are no farther apart than this may be reported. It is the rounding allowance of both boxes
// plus the declared margin of both (m).
double reach(const Scene& scene, const oracle::Card& card) {
  return rounding_of_a_pair(scene, card.precision) + margin_of_a_pair(card);
}

// Agreement with the exact answer

Finding misses_none(const Scene& scene, Subject& subject) {
  return of_pairs(scene, subject, [&](const PairSet& said) {
    const PairSet missed = without(truth::broad_phase(scene), as_set(said, scene));
    if (missed.empty()) return judge::holds();
    double deepest = 0;
    for (const Pair& pair : missed) deepest = std::max(deepest, -gap(scene, pair).nearest());
    return missed_pairs(scene, subject.card(), deepest, "without " + words::text(missed));
  });
}

Finding adds_none(const Scene& scene, Subject& subject) {
  return of_pairs(scene, subject, [&](const PairSet& said) {
    const PairSet extra = without(as_set(said, scene), truth::broad_phase(scene));
    double widest = 0;
    const Scene bodies = boxed(scene, subject.card().boxes);
    for (const Pair& pair : extra) widest = std::max(widest, gap(bodies, pair).nearest());
    Finding finding = judge::at_most(
        widest, judge::in_ulps(scene, subject.card(), reach(scene, subject.card())), Defect::phantom,
        [&] { return "with " + words::text(extra); },
        [] { return std::string("no pair whose boxes are further apart"); });
    if (finding.outcome == oracle::Outcome::fails) finding.margin = Interval{widest, widest};
    return finding;
  });
}

Finding well_formed(const Scene& scene, Subject& subject) {
  return of_pairs(scene, subject, [&](const PairSet& said) {
    if (is_well_formed(said, scene)) return judge::holds();
    return judge::wrong(Defect::garbage, words::text(said), "pairs i < j of bodies, sorted, each once");
  });
}

// Laws: how the answer follows a change of the scene

Pair same(const Pair& pair) { return pair; }

// The effect of a transform: the factor on lengths, and the new indices of a pair.
struct Change {
  double times = 1;
  std::function<Pair(const Pair&)> renamed = same;
};

// Two answers about the same set of pairs may differ only in pairs that are free within the greater reach of the two
// scenes. Where pairs differ that overlap within rounding, the grade is A-, as of misses_none. A subject with a margin
// is asked only where lengths stay as they are.
Finding pairs_kept(const Scene& before, const std::optional<Scene>& moved, Subject& subject, Defect defect,
                   const Change& change = {}) {
  return of_moved(moved, subject, [&](const Scene& after) {
    return of_pairs(before, subject, [&](const PairSet& first) {
      return judge::given(subject.broad_phase(after), [&](const PairSet& second) {
        PairSet expected = as_set(first, before);
        for (Pair& pair : expected) pair = change.renamed(pair);
        expected = as_set(expected, after);
        const PairSet got = as_set(second, after);
        PairSet differ = without(expected, got);
        std::ranges::copy(without(got, expected), std::back_inserter(differ));
        if (differ.empty()) return judge::holds();
        const double free = std::max(change.times * reach(before, subject.card()), reach(after, subject.card()));
        const Scene declared = boxed(after, subject.card().boxes);
        double furthest = 0;
        std::erase_if(differ, [&](const Pair& pair) {
          const double g = gap(declared, pair).nearest();
          if (is_free(gap(after, pair).sign() > 0, g, free, subject.card())) return true;
          furthest = std::max(furthest, std::abs(g));
          return false;
        });
        if (differ.empty()) return judge::holds();
        const judge::Allowance allowed = judge::in_ulps(after, subject.card(), free);
        Finding finding =
            judge::wrong_by(furthest, allowed, defect, "differs by " + words::text(differ), "the same pairs as before");
        const oracle::Precision precision = subject.card().precision;
        const auto of_two_bodies = [](const Pair& pair) { return pair.first != pair.second; };
        if (std::ranges::all_of(differ, of_two_bodies)) {
          finding.rounding =
              std::max(change.times * rounding_of_a_pair(before, precision), rounding_of_a_pair(after, precision)) /
              allowed.unit;
        }
        return finding;
      });
    });
  });
}

Finding translates(const Scene& scene, Subject& subject) {
  return pairs_kept(scene, translated(scene), subject, Defect::moved_with_frame);
}

Finding turns(const Scene& scene, Subject& subject) {
  return pairs_kept(scene, turned(scene), subject, Defect::relabelled);
}

Finding scales(const Scene& scene, Subject& subject) {
  const oracle::Card& card = subject.card();
  if (card.broad_phase_margin > 0) return judge::outside("a margin in metres does not scale");
  const Finding larger = pairs_kept(scene, scaled(scene, 20), subject, Defect::scaled, {0x1p20, same});
  if (larger.outcome != oracle::Outcome::holds) return larger;
  return pairs_kept(scene, scaled(scene, -20), subject, Defect::scaled, {0x1p-20, same});
}

Finding relabels(const Scene& scene, Subject& subject) {
  const int last = static_cast<int>(scene.bodies.size()) - 1;
  const auto renamed = [last](const Pair& pair) { return Pair(last - pair.first, last - pair.second); };
  return pairs_kept(scene, swapped(scene), subject, Defect::relabelled, {1, renamed});
}

// Robustness and determinism

Finding lives(const Scene& scene, Subject& subject) {
  const auto any_set_has_sense = [](const PairSet&) { return std::string(); };
  return of_still(scene, subject, [&] { return survives(&Subject::broad_phase, scene, subject, any_set_has_sense); });
}

Finding again(const Scene& scene, Subject& subject) {
  return of_still(scene, subject, [&] { return repeats(&Subject::broad_phase, scene, swapped(scene), subject); });
}

}  // namespace

std::vector<Property> broad_phase_properties() {
  return {
      {"broad_phase.misses_none",
       "broad_phase",
       {"TS-BROAD-PHASE-1"},
       "every pair whose closed boxes intersect is reported",
       misses_none},
      {"broad_phase.adds_none",
       "broad_phase",
       {"TS-BROAD-PHASE-2"},
       "no pair is reported whose boxes are further apart than rounding and the declared margin",
       adds_none},
      {"broad_phase.well_formed",
       "broad_phase",
       {"TS-BROAD-PHASE-3"},
       "pairs are i < j, sorted, each once",
       well_formed},
      {"broad_phase.translated",
       "broad_phase",
       {"TS-BROAD-PHASE-4"},
       "translating the world changes no pair",
       translates},
      {"broad_phase.turned", "broad_phase", {"TS-BROAD-PHASE-4"}, "permuting the world's axes changes no pair", turns},
      {"broad_phase.scaled",
       "broad_phase",
       {"TS-BROAD-PHASE-5"},
       "scaling all lengths by 2^20 or 2^-20 changes no pair",
       scales},
      {"broad_phase.relabelled",
       "broad_phase",
       {"TS-BROAD-PHASE-6"},
       "reordering the bodies renumbers the pairs, nothing else",
       relabels},
      {"broad_phase.survives", "broad_phase", {"TS-BROAD-PHASE-7"}, "every valid scene has an answer", lives},
      {"broad_phase.repeats", "broad_phase", {"TS-BROAD-PHASE-8"}, "the same query has the same answer", again},
  };
}

}  // namespace touchstone::properties
