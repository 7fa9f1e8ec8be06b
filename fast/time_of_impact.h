// When two bodies in flight meet.
#pragma once

#include <span>

#include "fast/motion/flight.h"
#include "fast/time_of_impact/swelling.h"
#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// hit        They are apart before `lo`, and share a point at some time of [lo, hi]; with an envelope ε > 0 instead:
///            at lo = hi they are at most ε apart and approach at C, or no more than rounding tells parts them there.
/// miss       They are apart throughout.
/// undecided  They are apart before `lo`; somewhere in [lo, hi] they come as near as `gap` (m), and doubles do not see
///            whether they meet.
/// Contact at `from` counts if they approach there.
struct Meeting {
  TimeOfImpact::Meeting meeting = TimeOfImpact::Meeting::miss;
  double lo = 0;
  double hi = 0;
  double gap = 0;
  Vec3 p_WC = Vec3::Zero();       ///< of a hit: midway between the witness points at `lo`
  Vec3 nhat_BA_W = Vec3::Zero();  ///< from b to a
  int looks = 0;                  ///< how often the two were looked at: what it cost
};

/// Requires until ≥ from ≥ both flights' `since`, and that the two do not overlap at `from`.
///
/// Law: `lo` is never later than the exact time, rounding included (docs/design/time_of_impact.md). Split: what is
/// found over [from, until] is what is found over [from, s], or else over [s, until], within the enclosures.
///
/// `memory`: one entry a pair of parts, as lin_canny::nearest_parts wants it: where the walks begin and ended.
/// `swelling`: where paths are known no better, a counts as so much thicker; then the two may overlap at `from`.
Meeting time_of_impact(const motion::Flight& a, const motion::Flight& b, double from, double until, double envelope,
                       std::span<lin_canny::FeaturePair> memory, const Swelling& swelling = {});

/// The same without memory of an earlier look.
Meeting time_of_impact(const motion::Flight& a, const motion::Flight& b, double from, double until,
                       double envelope = 0);

/// Of bodies 0 (A) and 1 (B) over the scene's flight. Requires a valid scene with a flight, whose polytopes have their
/// faces; throws InputError where there is none, or the two overlap at the start.
TimeOfImpact time_of_impact_of(const Scene& scene);

}  // namespace touchstone::fast
