// The doors of the properties about motion: two bodies in flight, when they meet, and how surely that is so.
#pragma once

#include <optional>
#include <string>

#include "model/answers.h"
#include "oracle/judge.h"
#include "oracle/truth.h"
#include "properties/asking.h"

namespace touchstone::properties {

/// When a scene's flights begin and end: both bodies have started; s.
double start_of(const Scene& pair);
double end_of(const Scene& scene);

/// Is a pose that is right to `slack` (m) right enough to tell where the body is, and of bodies 0 and 1 whether they
/// meet?
bool tells(const Body& body, double slack);
bool tells(const Scene& pair, double slack);

/// What a property says where they are not: a bound as wide as the bodies lets any answer through.
inline constexpr const char* too_far_to_tell = "rounding moves the bodies too far to tell";

/// What fails fails; what holds where nothing is told is outside.
inline oracle::Finding counted(bool told, oracle::Finding found) {
  const bool says_nothing = !told && found.outcome == oracle::Outcome::holds;
  return says_nothing ? oracle::judge::outside(too_far_to_tell) : found;
}

/// Bodies 0 and 1 in flight. A computation whose poses are right to `slack` (m) cannot put their meeting where the two
/// are farther apart than that at all times before, nor later than a time at which they overlap by more.
class FlightCase {
 public:
  FlightCase(const Scene& pair, oracle::Precision precision);

  const Scene& scene;
  oracle::Precision precision;
  reference::TimeOfImpactTruth truth;
  double start, end;  ///< s
  double slack = 0;   ///< m; tolerance::meeting at the meeting, else at the end
  double moment = 0;  ///< s: it takes the two at least so long to move by the slack against each other

  bool sure() const;  ///< does its slack tell?
  /// m: how far apart the two are at a time of their flights; below 0: how deep they overlap, at least.
  double gap(double time) const;
  /// m: 0, or below it the least gap from the truth's meeting until `until` that times which close in on the meeting
  /// show.
  double deepest(double until) const;
  /// Is the gap at one of those times below −slack? Then no rounding makes a miss of it.
  bool certainly_met(double until) const { return deepest(until) < -slack; }
  /// s: a careful computation's meeting is not before; none: it may see no meeting.
  std::optional<double> earliest() const;
  /// s: nor is it after; none: it may see none, or a later one.
  std::optional<double> latest() const;
};

/// None where the reference refuses the question: the two overlap at the start.
std::optional<FlightCase> flight_case(const Scene& pair, oracle::Precision precision);

/// A bound in metres, counted in ulps of the scene's scale.
oracle::judge::Allowance in_ulps_of_place(const FlightCase& asked, double bound);

/// Passes pairs with a flight that the subject's precision can hold, apart or touching at the start, to
/// judge_it(const FlightCase&).
template <class JudgeIt>
oracle::Finding of_flight(const Scene& scene, const oracle::Subject& subject, JudgeIt&& judge_it) {
  if (!scene.flight) return oracle::judge::outside("no flight");
  return of_pair(scene, subject, [&] {
    const std::optional<FlightCase> asked = flight_case(scene, subject.card().precision);
    if (!asked) return oracle::judge::outside("they overlap at the start");
    return asked->sure() ? judge_it(*asked) : oracle::judge::outside(too_far_to_tell);
  });
}

/// Asks, and passes on what the subject says: judge_it(const FlightCase&, const TimeOfImpact&).
template <class JudgeIt>
oracle::Finding of_answered_flight(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  return of_flight(scene, subject, [&](const FlightCase& asked) {
    return oracle::judge::given(subject.time_of_impact(scene),
                                [&](const TimeOfImpact& said) { return judge_it(asked, said); });
  });
}

std::string text(const TimeOfImpact& said);
std::string text(const reference::TimeOfImpactTruth& truth);

}  // namespace touchstone::properties
