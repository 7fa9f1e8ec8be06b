// A certified enclosure of the first contact of bodies 0 (A) and 1 (B) in ballistic motion.
//
// Both move as docs/design/simulation.md says, each from its own start time; the search begins when both have started.
// The first contact is the first time at which they share a point. Contact at the start counts if they approach there:
// some point of the contact has n·(v_A − v_B) < 0 for every n, from B to A, whose plane separates the two at the
// contact. They separate there if some such n has n·(v_A − v_B) > 0 at all points of the contact; then the search
// continues. Contact at the start that does neither is undecided.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::reference {

/// The first contact, or the proof that there is none; points and directions in W.
struct TimeOfImpactTruth {
  TimeOfImpact::Status status = TimeOfImpact::Status::undecided;

  /// s. hit: the first contact is in [lo, hi]. miss: lo and hi are the end of the motion, until which the two are
  /// apart. undecided: the two are apart before lo, within `gap` at lo, and hi is the end of the motion.
  Interval time;
  bool at_start = false;  ///< hit or undecided because of contact at the start: lo = start
  double gap = 0;         ///< m; undecided: upper bound of the distance at lo, infinite if none is known
  /// hit, undecided: unit normal, from B to A, of a plane between the two at lo; to rounding
  Vec3 nhat_BA_W = Vec3::Zero();
  Vec3 p_WCa = Vec3::Zero();  ///< closest points at lo, to rounding
  Vec3 p_WCb = Vec3::Zero();
};

/// Envelope, law and coefficients play no part. Requires a completed scene (reference/validity.h) of two bodies or
/// more, with a motion. Throws InputError if the two overlap at the start (naming the pair and the depth), if an
/// applied force of either begins after that body's start (ask again from its time on), if the motion ends before
/// both have started, or if a given inertia is not positive definite exactly. Error: enclosed; the width is that of
/// rounding over the approach speed, usually some 1e-14 s; of bodies that translate uniformly relative to each other
/// it may be one ulp. Gives up: undecided where the contact is so grazing that 76 digits do not decide, and one of
/// the two rotates, or their accelerations differ, or a ball overlaps by as little, or where contact at the start
/// neither separates nor approaches. Cost: docs/design/time_of_impact.md.
TimeOfImpactTruth time_of_impact(const Scene& scene);

/// The first time, from `from` on, at which the distance is at most `apart` (m, ≥ 0). A hit at the start if that holds
/// there, whether they approach, separate or overlap. For impacts within an envelope: no impact can come earlier.
TimeOfImpactTruth time_of_distance(const Scene& scene, double apart, double from = 0);

}  // namespace touchstone::reference
