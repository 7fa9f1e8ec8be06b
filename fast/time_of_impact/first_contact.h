// The first contact of two bodies on prepared trajectories.
#pragma once

#include <span>

#include "fast/motion/ballistic_motion.h"
#include "fast/time_of_impact/inflation.h"
#include "model/answers.h"

namespace touchstone::fast {

/// The first contact of two bodies.
///   hit        They are separated before `lo`, and share a point at some time in [lo, hi]. With an envelope ε > 0,
///              instead: at lo = hi they are at most ε apart, and approach at C or are separated by no more than
///              rounding.
///   miss       They are separated throughout.
///   undecided  They are separated before `lo`; somewhere in [lo, hi] their distance falls to `gap` (m) or less, and
///              doubles cannot decide whether they touch.
/// A contact at `from` counts if they approach there.
struct FirstContact {
  TimeOfImpact::Status status = TimeOfImpact::Status::miss;
  double lo = 0;
  double hi = 0;
  double gap = 0;
  Vec3 p_WC = Vec3::Zero();       ///< hit only: midway between the witness points at `lo`
  Vec3 nhat_BA_W = Vec3::Zero();  ///< from b to a
  int queries = 0;                ///< cost: the number of separation queries
  bool is_cut_off = false;        ///< undecided only: the search needed more separation queries than it may take
};

/// Requires until ≥ from ≥ both motions' since(), and that the two bodies do not overlap at `from`.
///
/// Law: `lo` is never later than the exact time, rounding included (docs/design/time_of_impact.md). Splitting: within
/// the enclosures, the result over [from, until] is that over [from, s], or else that over [s, until].
///
/// `memory`: one entry per pair of parts, as for lin_canny::nearest_parts: where its walk starts, and afterwards where
/// it ended. `inflation`: the margin by which a is inflated while the trajectories are uncertain; the inflated bodies
/// may then overlap at `from`.
FirstContact first_contact(const motion::BallisticMotion& a, const motion::BallisticMotion& b, double from,
                           double until, double envelope, std::span<lin_canny::FeaturePair> memory,
                           const Inflation& inflation = {});

/// The same without the memory of an earlier query.
FirstContact first_contact(const motion::BallisticMotion& a, const motion::BallisticMotion& b, double from,
                           double until, double envelope = 0);

}  // namespace touchstone::fast
