// When do bodies 0 (A) and 1 (B) first meet in flight? A certified enclosure.
//
// They fly as docs/design/simulation.md says, each from its own `since`; time begins when both have started. They meet
// at the first time at which they share a point; contact at the start counts if they approach there: some point of the
// contact has n·(v_A − v_B) < 0 for every n, from B to A, whose plane separates the two at the contact. They part there
// if some such n has n·(v_A − v_B) > 0 at all points of the contact, and then time goes on. What is neither is
// undecided.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::reference {

struct TimeOfImpactTruth {
  TimeOfImpact::Meeting meeting = TimeOfImpact::Meeting::undecided;

  /// s. hit: the first meeting is in [lo, hi]. miss: both are the end of the flight, until which the two are apart.
  /// undecided: the two are apart before lo, come as near as `gap` at lo, and hi is the end of the flight.
  Interval time;
  bool at_start = false;          ///< a hit or undecided because of contact at the start: lo = start
  double gap = 0;                 ///< m; undecided: the distance at lo is at most this
  Vec3 nhat_BA_W = Vec3::Zero();  ///< hit, undecided: unit, from B to A, of a plane between the two at lo; to rounding
  Vec3 p_WCa = Vec3::Zero();      ///< closest points at lo, to rounding
  Vec3 p_WCb = Vec3::Zero();
};

/// Envelope, law and coefficients play no part. Requires a completed scene (reference/validity.h) of two bodies or
/// more, with a flight. Throws InputError if the two overlap at the start (naming the pair and the depth), if a push of
/// either begins after that body's start (ask from its time on), if the flight ends before both have started, or if a
/// given inertia is not positive definite exactly. Error: enclosed; the width is that of rounding over the approach
/// speed, some 1e-14 s as a rule. Gives up: undecided where they graze so closely that 76 digits do not tell, or where
/// contact at the start neither parts nor approaches. Cost: docs/design/time_of_impact.md.
TimeOfImpactTruth time_of_impact(const Scene& scene);

/// The first time, from `from` on, at which the distance is at most `apart` (m, ≥ 0); a hit at the start if it is so
/// there, however the two move, or overlap. For impacts within an envelope: no impact may come before.
TimeOfImpactTruth time_of_distance(const Scene& scene, double apart, double from = 0);

}  // namespace touchstone::reference
