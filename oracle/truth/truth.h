// The oracle: the exact truth about a scene, cached so that several subjects and properties share one computation.
//
// Properties and generators use the reference only through this header; it has plain values and exact value types only.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "model/scene.h"
#include "reference/ballistic_motion.h"
#include "reference/bounds.h"
#include "reference/broad_phase.h"
#include "reference/constraint.h"
#include "reference/distance.h"
#include "reference/impact_conditions.h"
#include "reference/impulse.h"
#include "reference/mass.h"
#include "reference/penetration.h"
#include "reference/pixel.h"
#include "reference/time_of_impact.h"

namespace touchstone::oracle::truth {

/// Each function caches the last few scenes of this thread. The returned reference stays valid until the thread has
/// asked about `remembered` other scenes. A choice: a property uses a scene and at most a few images of it, and the
/// scene comes again for each subject.
inline constexpr int remembered = 8;

const std::vector<std::optional<reference::MassTruth>>& mass(const Scene& scene);
const std::vector<reference::ExactBox>& bounds(const Scene& scene);
const PairSet& broad_phase(const Scene& scene);
const std::vector<reference::FrameBoxes>& sequence_bounds(const Scene& sequence);
const PairHistory& pair_history(const Scene& sequence);
const reference::DistanceTruth& distance(const Scene& scene);
const reference::PenetrationTruth& penetration(const Scene& scene);
/// Computed to `some` digits for every subject, so a scene's truth does not depend on the subject.
const reference::ImpulseTruth& impulse(const Scene& scene);

/// See reference/impact_conditions.h. Not cached.
std::array<double, reference::impact_conditions> impact_condition_errors(const reference::ReportedImpacts& reported);

/// A trajectory consists of many ballistic motions, and several properties judge it: more of these are cached. A
/// choice: enough for the events of most scenes that are drawn.
inline constexpr int remembered_motions = 256;
const reference::TimeOfImpactTruth& time_of_impact(const Scene& scene);
const reference::TimeOfImpactTruth& time_of_distance(const Scene& scene, double apart, double from = 0);
const reference::BallisticTruth& ballistic_state(const Scene& scene, std::size_t body, double time);

/// The truth, or the reason why the scene is outside.
using ConstraintOrWhy = std::variant<reference::ConstraintTruth, std::string>;
const ConstraintOrWhy& constraint(const Scene& scene);

const Pixels& pixel(const Scene& scene);

/// See reference/pixel.h. Not cached.
bool projection_comes_near(const Scene& scene, std::size_t body, int column, int row, int around);
bool depths_come_near(const Scene& scene, int column, int row, int around, double apart);

/// reference::convex_hull and reference::completed, for generators and the minimiser.
Polytope convex_hull(const std::vector<Vec3>& points);
Scene completed(Scene scene);

}  // namespace touchstone::oracle::truth
