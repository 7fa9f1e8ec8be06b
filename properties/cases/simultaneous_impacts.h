// Which impacts of a trajectory that are at one time act together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

#include "properties/cases/trajectory_case.h"

namespace touchstone::properties {

inline constexpr const char* together_with_others = "acts together with other impacts at its time";

/// Remembers what it has found out, since a row of balls that come to rest in each other has thousands of impacts at
/// one time. What it is made of must outlive it.
class SimultaneousImpacts {
 public:
  SimultaneousImpacts(const TrajectoryCase& asked, const Timeline& timeline) : asked_(asked), timeline_(timeline) {}

  /// Whether another impact at the same time acts together with this one: it acts on a common body that moves, and
  /// before the first of the two both contacts approach; or with a contact that holds one of the bodies until then.
  /// Then the law of one contact says nothing about it. Two convex bodies have one contact region, which acts as one.
  /// Parts of a compound act as one too, those that separate included, so all impacts of one pair act together.
  bool act_together_with(const Event& impact);

 private:
  /// The events at one time are those from `first` on, before `end`.
  struct Instant {
    std::size_t first = 0, end = 0;
    std::vector<std::size_t> contact_of;  ///< of each event: the first one with the same contact
    /// By contact, of those that several events have, before each event; -1: not asked yet.
    std::map<std::size_t, std::vector<signed char>> approaches;
  };

  const Instant& at(std::size_t event);
  bool approaches_before(std::size_t impact, std::size_t event);
  bool holds_before(std::size_t event, const Event& impact) const;

  const TrajectoryCase& asked_;
  const Timeline& timeline_;
  Instant now_;
};

/// For answers with events, passes on each impact of bodies in ballistic motion: judge_it(const TrajectoryCase&, const
/// Event&, the segments that it ends, whether another impact acts together with it).
template <class JudgeIt>
oracle::Finding of_impacts(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    oracle::Finding worst = oracle::judge::outside("no impact of bodies in ballistic motion");
    SimultaneousImpacts simultaneous(asked, timeline);
    for (std::size_t e = 0; e < asked.events(); ++e) {
      const Event& event = (*asked.said.events)[e];
      if (event.kind != Event::Kind::impact) continue;
      const std::vector<Segment> segments = segments_into(timeline, asked.said, e);
      if (!std::ranges::all_of(segments, &Segment::ballistic)) continue;
      if (worse(worst, judge_it(asked, event, segments, simultaneous.act_together_with(event)))) break;
    }
    return worst;
  });
}

}  // namespace touchstone::properties
