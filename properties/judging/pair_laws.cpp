#include "properties/judging/pair_laws.h"

#include <cmath>

#include "oracle/judge/words.h"
#include "oracle/query.h"
#include "oracle/tolerance/tolerance.h"
#include "properties/judging/asking.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Finding;
namespace judge = oracle::judge;
namespace words = oracle::words;

Finding same_verdict(const Scene& scene, Verdict first, Verdict second, const oracle::Card& card,
                     oracle::Defect defect) {
  if (first == second) return judge::holds();
  const double misjudged = judge::margin(scene).lo, allowed = judge::verdict_allowance(scene, card);
  if (misjudged <= allowed && !judge::is_held_to_touching(card)) return judge::holds();
  return judge::explained(judge::wrong_by(misjudged, judge::in_ulps(scene, card, allowed), defect,
                                          words::text(first) + ", then " + words::text(second), "the same verdict"),
                          scene);
}

Finding same_length(const Scene& before, double first, const Scene& after, double second, double times,
                    const oracle::Card& card, oracle::Defect defect) {
  const oracle::DistanceTolerance& declared = card.distance_tolerance;
  const double allowed = times * (oracle::tolerance::distance(before, card.precision) + declared.of(first)) +
                         oracle::tolerance::distance(after, card.precision) + declared.of(second);
  return judge::at_most(
      std::abs(second - times * first), judge::in_ulps(after, card, allowed), defect,
      [&] { return words::text(second); }, [&] { return words::text(times * first) + ", as before"; });
}

template <class T>
Finding unchanged(oracle::QueryFunction<T> query, const Scene& before, const std::optional<Scene>& moved, double times,
                  oracle::Subject& subject, oracle::Defect defect) {
  return of_moved(moved, subject, [&](const Scene& after) {
    return judge::given((subject.*query)(before), [&](const T& answer_before) {
      return judge::given((subject.*query)(after), [&](const T& answer_after) {
        const Said first = said(answer_before), second = said(answer_after);
        const bool verdicts = first.verdict && second.verdict, lengths = first.length && second.length;
        if (!verdicts && !lengths) return judge::silent("a verdict or a length, both times");
        if (verdicts) {
          Finding finding = same_verdict(before, *first.verdict, *second.verdict, subject.card(), defect);
          if (finding.outcome != oracle::Outcome::holds || !lengths) return finding;
        }
        return judge::explained(
            same_length(before, *first.length, after, *second.length, times, subject.card(), defect), before);
      });
    });
  });
}

}  // namespace

Finding distance_unchanged(const Scene& before, const std::optional<Scene>& after, double times,
                           oracle::Subject& subject, oracle::Defect defect) {
  return unchanged(&oracle::Subject::distance, before, after, times, subject, defect);
}

Finding penetration_unchanged(const Scene& before, const std::optional<Scene>& after, double times,
                              oracle::Subject& subject, oracle::Defect defect) {
  return unchanged(&oracle::Subject::penetration, before, after, times, subject, defect);
}

std::optional<Scene> some_turn(const Scene& scene) {
  const std::optional<Scene> cyclic = turned(scene);
  return cyclic ? cyclic : half_turned(scene);
}

}  // namespace touchstone::properties
