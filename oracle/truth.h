// The Oracle: the exact truth about a scene, remembered so that several subjects and properties ask for it once.
//
// The door through which properties and generators reach the reference; plain values and exact value types only.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "model/scene.h"
#include "reference/bounds.h"
#include "reference/broad_phase.h"
#include "reference/constraint.h"
#include "reference/distance.h"
#include "reference/flight.h"
#include "reference/impulse.h"
#include "reference/mass.h"
#include "reference/penetration.h"
#include "reference/pixel.h"
#include "reference/time_of_impact.h"

namespace touchstone::oracle::truth {

/// Each remembers the last few scenes of this thread. The reference stays valid until the thread has asked about
/// `remembered` other scenes.
inline constexpr int remembered = 8;

const std::vector<std::optional<reference::MassTruth>>& mass(const Scene& scene);
const std::vector<reference::ExactBox>& bounds(const Scene& scene);
const PairSet& broad_phase(const Scene& scene);
const std::vector<reference::FrameBoxes>& film_bounds(const Scene& film);
const PairHistory& pair_history(const Scene& film);
const reference::DistanceTruth& distance(const Scene& scene);
const reference::PenetrationTruth& penetration(const Scene& scene);
/// To some digits: what any subject is judged by, so a scene's truth does not depend on who is asked.
const reference::ImpulseTruth& impulse(const Scene& scene);

/// A trajectory is many flights, and several properties judge it: more of these are remembered.
inline constexpr int remembered_flights = 256;
const reference::TimeOfImpactTruth& time_of_impact(const Scene& scene);
const reference::TimeOfImpactTruth& time_of_distance(const Scene& scene, double apart, double from = 0);
const reference::FlightTruth& flown(const Scene& scene, std::size_t body, double time);

/// Or why the scene is outside.
using ConstraintOrWhy = std::variant<reference::ConstraintTruth, std::string>;
const ConstraintOrWhy& constraint(const Scene& scene);

const Pixels& pixel(const Scene& scene);

/// reference/pixel.h; not remembered.
bool picture_comes_near(const Scene& scene, std::size_t body, int column, int row, int around);
bool depths_come_near(const Scene& scene, int column, int row, int around, double apart);

/// reference::convex_hull and reference::completed, for generators and the minimiser.
Polytope convex_hull(const std::vector<Vec3>& points);
Scene completed(Scene scene);

}  // namespace touchstone::oracle::truth
