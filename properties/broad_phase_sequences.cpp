// The clauses of docs/spec/broad_phase.md about sequences as executable properties.

#include <algorithm>
#include <cmath>
#include <functional>

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

template <class JudgeIt>
Finding of_sequence(const Scene& sequence, Subject& subject, JudgeIt&& judge_it) {
  if (!is_sequence(sequence)) return judge::outside("the scene has no frames");
  return of_scene(sequence, subject, [&] {
    return judge::given(subject.pair_history(sequence), [&](const PairHistory& said) {
      if (said.size() == sequence.frames.size()) return judge_it(said);
      return judge::wrong(Defect::garbage, std::to_string(said.size()) + " frames",
                          "one entry for each of " + std::to_string(sequence.frames.size()));
    });
  });
}

std::string in_frame(std::size_t f, const std::string& what) { return "frame " + std::to_string(f) + ": " + what; }

/// The same bound as for a single scene: the pairs of a frame depend only on the current poses, not on the path to
/// them.
judge::Allowance reach(const Scene& sequence, std::size_t f, const oracle::Card& card) {
  const Scene scene = snapshot(sequence, f);
  return judge::in_ulps(scene, card, rounding_of_a_pair(scene, card.precision) + margin_of_a_pair(card));
}

bool both_there(const reference::FrameBoxes& boxes, const Pair& pair) {
  return boxes[static_cast<std::size_t>(pair.first)] && boxes[static_cast<std::size_t>(pair.second)];
}

double gap(const reference::FrameBoxes& boxes, const Pair& pair) {
  if (pair.first == pair.second) return 0;
  return reference::gap(*boxes[static_cast<std::size_t>(pair.first)], *boxes[static_cast<std::size_t>(pair.second)])
      .nearest();
}

// Agreement with the exact answer

Finding misses_none(const Scene& sequence, Subject& subject) {
  return of_sequence(sequence, subject, [&](const PairHistory& said) {
    const PairHistory& truth = truth::pair_history(sequence);
    for (std::size_t f = 0; f < said.size(); ++f) {
      const PairSet missed = without(truth[f].pairs, as_set(said[f].pairs, sequence));
      if (missed.empty()) continue;
      double deepest = 0;
      for (const Pair& pair : missed) deepest = std::max(deepest, -gap(truth::sequence_bounds(sequence)[f], pair));
      return missed_pairs(snapshot(sequence, f), subject.card(), deepest,
                          in_frame(f, "without " + words::text(missed)));
    }
    return judge::holds();
  });
}

/// Judges the reported pairs of frame f whose bodies are both present and whose boxes are apart, by the widest gap of
/// the boxes that the subject declares.
Finding extra_in(const Scene& sequence, std::size_t f, const PairSet& said, const oracle::Card& card) {
  PairSet extra = without(as_set(said, sequence), truth::pair_history(sequence)[f].pairs);
  if (extra.empty()) return judge::holds();
  const reference::FrameBoxes& boxes = truth::sequence_bounds(boxed(sequence, card.boxes))[f];
  std::erase_if(extra, [&](const Pair& pair) { return !both_there(boxes, pair); });
  if (extra.empty()) return judge::holds();
  double widest = 0;
  for (const Pair& pair : extra) widest = std::max(widest, gap(boxes, pair));
  Finding finding = judge::at_most(
      widest, reach(sequence, f, card), Defect::phantom, [&] { return in_frame(f, "with " + words::text(extra)); },
      [] { return std::string("no pair whose boxes are further apart"); });
  if (finding.outcome == oracle::Outcome::fails) finding.margin = Interval{widest, widest};
  return finding;
}

Finding adds_none(const Scene& sequence, Subject& subject) {
  return of_sequence(sequence, subject, [&](const PairHistory& said) {
    Finding worst = judge::holds();
    for (std::size_t f = 0; f < said.size() && worst.outcome == oracle::Outcome::holds; ++f) {
      const Finding finding = extra_in(sequence, f, said[f].pairs, subject.card());
      if (finding.outcome != oracle::Outcome::holds || finding.error >= worst.error) worst = finding;
    }
    return worst;
  });
}

Finding absent(const Scene& sequence, Subject& subject) {
  return of_sequence(sequence, subject, [&](const PairHistory& said) {
    const std::vector<Places> there = places(sequence);
    for (std::size_t f = 0; f < said.size(); ++f) {
      for (const Pair& pair : as_set(said[f].pairs, sequence)) {
        for (const int body : {pair.first, pair.second}) {
          if (there[f][static_cast<std::size_t>(body)]) continue;
          return judge::wrong(Defect::phantom, in_frame(f, "with " + words::text(PairSet{pair})),
                              "no pair of body " + std::to_string(body) + ", which is not in the scene at this frame");
        }
      }
    }
    return judge::holds();
  });
}

Finding well_formed(const Scene& sequence, Subject& subject) {
  return of_sequence(sequence, subject, [&](const PairHistory& said) {
    for (std::size_t f = 0; f < said.size(); ++f) {
      for (const PairSet& pairs :
           {said[f].pairs, said[f].begun.value_or(PairSet{}), said[f].ended.value_or(PairSet{})}) {
        if (is_well_formed(pairs, sequence)) continue;
        return judge::wrong(Defect::garbage, in_frame(f, words::text(pairs)),
                            "pairs i < j of bodies, sorted, each once");
      }
    }
    return judge::holds();
  });
}

Finding events(const Scene& sequence, Subject& subject) {
  return of_sequence(sequence, subject, [&](const PairHistory& said) {
    PairSet before;
    for (std::size_t f = 0; f < said.size(); ++f) {
      if (!said[f].begun || !said[f].ended) return judge::silent("which pairs begin and end");
      const PairSet now = as_set(said[f].pairs, sequence);
      const auto judged = [&](const std::string& word, const PairSet& claimed, const PairSet& due) {
        if (as_set(claimed, sequence) == due) return judge::holds();
        return judge::wrong(Defect::inconsistent, in_frame(f, word + ' ' + words::text(claimed)),
                            words::text(due) + ", the change of its own sets of pairs");
      };
      const Finding begun = judged("begun", *said[f].begun, without(now, before));
      if (begun.outcome != oracle::Outcome::holds) return begun;
      const Finding ended = judged("ended", *said[f].ended, without(before, now));
      if (ended.outcome != oracle::Outcome::holds) return ended;
      before = now;
    }
    return judge::holds();
  });
}

// Laws: how the answer follows a change of the scene

/// Two answers may differ only in free pairs of the frame. Where pairs differ that overlap within rounding, the grade
/// is A-, as of misses_none.
Finding none_but_free(const Scene& sequence, std::size_t f, PairSet differ, const oracle::Card& card, Defect defect,
                      const std::string& how, const std::string& expected) {
  if (differ.empty()) return judge::holds();
  const judge::Allowance free = reach(sequence, f, card);
  const reference::FrameBoxes boxes = truth::sequence_bounds(sequence)[f];  // a copy: the next call may replace it
  const reference::FrameBoxes& declared = truth::sequence_bounds(boxed(sequence, card.boxes))[f];
  double furthest = 0;
  std::erase_if(differ, [&](const Pair& pair) {
    if (!both_there(boxes, pair)) return false;
    const double g = gap(declared, pair);
    if (is_free(gap(boxes, pair) > 0, g, free.bound, card)) return true;
    furthest = std::max(furthest, std::abs(g));
    return false;
  });
  if (differ.empty()) return judge::holds();
  Finding finding = judge::wrong_by(furthest, free, defect, in_frame(f, how + ' ' + words::text(differ)), expected);
  // Rounding explains no pair of an absent body.
  const auto of_boxes = [&](const Pair& pair) { return pair.first != pair.second && both_there(boxes, pair); };
  if (std::ranges::all_of(differ, of_boxes)) {
    finding.rounding = rounding_of_a_pair(snapshot(sequence, f), card.precision) / free.unit;
  }
  return finding;
}

/// A transformed sequence. Its frame of(f) has the pairs of frame f; `renamed` maps the new indices back.
struct Image {
  std::optional<Scene> sequence;
  std::function<std::size_t(std::size_t)> of = [](std::size_t f) { return f; };
  std::function<Pair(const Pair&)> renamed = [](const Pair& pair) { return pair; };
};

Finding pairs_kept(const Scene& sequence, const Image& image, Subject& subject, Defect defect) {
  if (!is_sequence(sequence)) return judge::outside("the scene has no frames");
  return of_moved(image.sequence, subject, [&](const Scene& other) {
    return of_sequence(sequence, subject, [&](const PairHistory& first) {
      return of_sequence(other, subject, [&](const PairHistory& second) {
        for (std::size_t f = 0; f < first.size(); ++f) {
          PairSet expected = as_set(first[f].pairs, sequence);
          PairSet got = as_set(second[image.of(f)].pairs, sequence);
          for (Pair& pair : got) pair = image.renamed(pair);
          const Finding finding = none_but_free(sequence, f, difference(expected, as_set(got, sequence)),
                                                subject.card(), defect, "differs by", "the same pairs as before");
          if (finding.outcome != oracle::Outcome::holds) return finding;
        }
        return judge::holds();
      });
    });
  });
}

/// Inserts two frames after each frame: an empty one, and one that sets each body to its current pose.
Scene with_still_frames(const Scene& sequence) {
  const std::vector<Places> there = places(sequence);
  Scene slow = sequence;
  slow.frames.clear();
  for (std::size_t f = 0; f < there.size(); ++f) {
    SequenceFrame again;
    for (std::size_t i = 0; i < there[f].size(); ++i) {
      if (there[f][i]) again.push_back({static_cast<int>(i), there[f][i]});
    }
    for (const SequenceFrame& frame : {sequence.frames[f], SequenceFrame{}, again}) slow.frames.push_back(frame);
  }
  return slow;
}

Finding keeps_still(const Scene& sequence, Subject& subject) {
  if (!is_sequence(sequence)) return judge::outside("the scene has no frames");
  const Scene slow = with_still_frames(sequence);
  return of_sequence(slow, subject, [&](const PairHistory& said) {
    for (std::size_t f = 0; f < said.size(); ++f) {
      if (f % 3 == 0) continue;
      const PairSet changed = difference(as_set(said[f - 1].pairs, sequence), as_set(said[f].pairs, sequence));
      for (const PairSet& pairs : {changed, as_set(said[f].begun.value_or(PairSet{}), sequence),
                                   as_set(said[f].ended.value_or(PairSet{}), sequence)}) {
        const Finding finding =
            none_but_free(slow, f, pairs, subject.card(), Defect::inconsistent,
                          "no body moved, but these pairs begin or end", "no pair that begins or ends");
        if (finding.outcome != oracle::Outcome::holds) return finding;
      }
    }
    return judge::holds();
  });
}

/// Before each frame, removes all bodies and then inserts them one by one, last body first. So no body reaches its pose
/// by a move.
Scene rebuilt(const Scene& sequence) {
  Scene result = sequence;
  result.frames.clear();
  Places before(sequence.bodies.size());
  for (const Places& there : places(sequence)) {
    SequenceFrame go;
    SequenceFrame come;
    for (std::size_t i = there.size(); i-- > 0;) {
      if (before[i]) go.push_back({static_cast<int>(i), {}});
      if (there[i]) come.push_back({static_cast<int>(i), there[i]});
    }
    result.frames.push_back(std::move(go));
    result.frames.push_back(std::move(come));
    before = there;
  }
  return result;
}

Finding path_free(const Scene& sequence, Subject& subject) {
  return pairs_kept(sequence, {.sequence = rebuilt(sequence), .of = [](std::size_t f) { return 2 * f + 1; }}, subject,
                    Defect::inconsistent);
}

Finding turns(const Scene& sequence, Subject& subject) {
  return pairs_kept(sequence, {.sequence = turned(sequence)}, subject, Defect::relabelled);
}

Finding relabels(const Scene& sequence, Subject& subject) {
  const int last = static_cast<int>(sequence.bodies.size()) - 1;
  const auto renamed = [last](const Pair& pair) { return Pair(last - pair.second, last - pair.first); };
  return pairs_kept(sequence, {.sequence = swapped(sequence), .renamed = renamed}, subject, Defect::relabelled);
}

// Robustness and determinism

Finding lives(const Scene& sequence, Subject& subject) {
  return of_sequence(sequence, subject, [](const PairHistory&) { return judge::holds(); });
}

Finding again(const Scene& sequence, Subject& subject) {
  if (!is_sequence(sequence)) return judge::outside("the scene has no frames");
  return of_scene(sequence, subject,
                  [&] { return repeats(&Subject::pair_history, sequence, swapped(sequence), subject); });
}

Property about(const std::string& what, int clause, const std::string& says, Finding (*check)(const Scene&, Subject&)) {
  return {"broad_phase.film." + what, "broad_phase", {"TS-BROAD-PHASE-" + std::to_string(clause)}, says, check};
}

}  // namespace

std::vector<Property> broad_phase_sequence_properties() {
  return {
      about("misses_none", 9, "in every frame, every pair whose closed boxes intersect is reported", misses_none),
      about("adds_none", 10,
            "in no frame is a pair reported whose boxes are further apart than rounding and the declared margin",
            adds_none),
      about("absent", 11, "a body that has been removed is in no pair", absent),
      about("well_formed", 12, "the answer has one entry per frame, with pairs i < j, sorted, each once", well_formed),
      about("events", 13, "the begin and end events are the differences of successive sets of pairs", events),
      about("keeps_still", 14, "a frame in which no body moves has no begin or end events", keeps_still),
      about("path_free", 15, "the pairs of a frame depend only on the poses in it, not on earlier frames", path_free),
      about("turned", 16, "permuting the world's axes changes no pair of any frame", turns),
      about("relabelled", 16, "reordering the bodies renumbers the pairs, nothing else", relabels),
      about("survives", 17, "every valid sequence has an answer", lives),
      about("repeats", 18, "the same sequence has the same answer", again),
  };
}

}  // namespace touchstone::properties
