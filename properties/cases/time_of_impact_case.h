// The preconditions of the motion properties: two bodies in ballistic motion, their time of impact, and how certain it
// is.
#pragma once

#include <optional>
#include <string>

#include "model/answers.h"
#include "oracle/judge/judge.h"
#include "oracle/truth/truth.h"
#include "properties/judging/asking.h"

namespace touchstone::properties {

/// The times (s) at which a scene's motion starts (when both bodies have started) and ends.
double start_of(const Scene& pair);
double end_of(const Scene& scene);

/// Is a pose with an error of `slack` (m) accurate enough to say where the body is, and whether bodies 0 and 1 touch?
bool is_decisive(const Body& body, double slack);
bool is_decisive(const Scene& pair, double slack);

/// The reason of a property that does not judge then: a bound as wide as the bodies would accept any answer.
inline constexpr const char* too_far_to_decide = "rounding moves the bodies too far to decide";

/// Keeps a failure. A finding that holds becomes `outside` if the poses are too inaccurate to decide anything.
inline oracle::Finding counted(bool decisive, oracle::Finding found) {
  const bool says_nothing = !decisive && found.outcome == oracle::Outcome::holds;
  return says_nothing ? oracle::judge::outside(too_far_to_decide) : found;
}

/// Bodies 0 and 1 in ballistic motion. A computation with poses accurate to `slack` (m) cannot report contact at a time
/// if the two are farther apart than that at all times up to it, nor later than a time at which they overlap by more.
class MotionCase {
 public:
  MotionCase(const Scene& pair, oracle::Precision precision, const oracle::ContactTolerance& declared = {});

  const Scene& scene;
  oracle::Precision precision;
  reference::TimeOfImpactTruth truth;
  double start, end;   ///< s
  double granted = 0;  ///< m; what the subject declares of its contacts
  double slack = 0;    ///< m; that and tolerance::moving_distance at the contact, else at the end
  double moment = 0;   ///< s: the least time in which the two move by the slack relative to each other

  bool sure() const;  ///< is the slack small enough to decide?
  /// m: the distance of the two at a time of their motions; if negative, a lower bound of their overlap.
  double gap(double time) const;
  /// m: 0, or the least negative gap among times between the true contact and `until` that approach the contact.
  double deepest(double until) const;
  /// Is the gap below −slack at one of those times? Then no rounding can make it a miss.
  bool certainly_met(double until) const { return deepest(until) < -slack; }
  /// s: a careful computation finds no contact before this time; none: it may find no contact.
  std::optional<double> earliest() const;
  /// s: nor after this time; none: it may find none, or a later one.
  std::optional<double> latest() const;
};

/// Do the two overlap where the later one starts? The question is bad input then, and a subject may refuse it.
bool is_refused(const Scene& pair);

/// None where the two overlap at the start.
std::optional<MotionCase> motion_case(const Scene& pair, oracle::Precision precision,
                                      const oracle::ContactTolerance& declared = {});

/// A bound in metres, counted in ulps of the scene's scale.
oracle::judge::Allowance in_ulps_of_place(const MotionCase& asked, double bound);

/// Passes pairs with a motion that are exact in the subject's precision and apart or touching at the start to
/// judge_it(const MotionCase&).
template <class JudgeIt>
oracle::Finding of_motion(const Scene& scene, const oracle::Subject& subject, JudgeIt&& judge_it) {
  if (!scene.motion) return oracle::judge::outside("no motion");
  return of_pair(scene, subject, [&] {
    const oracle::Card& card = subject.card();
    const std::optional<MotionCase> asked = motion_case(scene, card.precision, card.contact_tolerance);
    if (!asked) return oracle::judge::outside("the bodies overlap at the start");
    return asked->sure() ? judge_it(*asked) : oracle::judge::outside(too_far_to_decide);
  });
}

/// Asks the subject and passes on its answer: judge_it(const MotionCase&, const TimeOfImpact&).
template <class JudgeIt>
oracle::Finding of_answered_motion(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  return of_motion(scene, subject, [&](const MotionCase& asked) {
    return oracle::judge::given(subject.time_of_impact(scene),
                                [&](const TimeOfImpact& said) { return judge_it(asked, said); });
  });
}

std::string text(const TimeOfImpact& said);
std::string text(const reference::TimeOfImpactTruth& truth);

}  // namespace touchstone::properties
