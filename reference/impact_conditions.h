// What every outcome of impacts at one time must obey, whatever law an engine follows, checked in exact numbers on what
// it tells: conditions N1 to N9 of docs/design/simultaneous.md.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/scene.h"
#include "reference/simultaneous.h"

namespace touchstone::reference {

/// What is reported of the impacts at one time.
struct ReportedImpacts {
  struct Impulse {
    std::size_t region = 0;
    Vec3 point_W = Vec3::Zero();
    Vec3 P_A_W = Vec3::Zero();  ///< N s, on the region's A
  };
  Scene before;                        ///< poses, velocities, masses and materials at that time; shapes are not used
  std::vector<ContactRegion> regions;  ///< of all pairs in contact, whether they approach or not
  std::vector<Impulse> impulses;
  std::vector<Velocity> after;  ///< of all bodies
};

/// The conditions. v, T: velocities and kinetic energy before; v', T' after; P_C v: the nearest velocities in energy at
/// which nothing approaches.
enum class ImpactCondition {
  momentum,      ///< N1: M(v' − v) = Σ GᵀP
  cone,          ///< N2: P_n ≥ 0, |P_t| ≤ μ P_n
  place,         ///< N3: each impulse acts in its region
  separation,    ///< N4: u_n' ≥ 0 at all corners of all regions
  energy,        ///< N5: T' ≤ T
  untouched,     ///< N6: bodies connected by regions of which none approaches keep their velocities
  least_energy,  ///< N7: without friction T' ≥ T(P_C v), with P_C v the nearest velocities at which nothing approaches
  elastic,       ///< N8: T' = T of connected bodies with e = 1, μ = 0, unless one is clamped between others
  symmetry       ///< N9: reflections of the coordinate axes that map the scene onto itself map the outcome onto itself
};
/// Their number.
constexpr std::size_t impact_conditions = 9;

/// By how much each condition is violated, in their order; exactly 0 where it is not, or where it does not apply.
/// Computed in rationals and then rounded. Relative to: N1, a body's energies of its velocities and its impulses (the
/// root of the quotient); N2, |P|; N3, the distance from the centres of mass; N4 and N9, the greatest speed of a corner
/// or body; N5, N7 and N8, T; N6, as N1.
///
/// N5, N7 and N8 ask nothing where a fixed body moves, since that does work; nor does N5 with Newton's law and
/// friction. N9 is a demand on laws that are functions of the scene: impacts one after the other obey N1 to N8.
/// Requires valid bodies. Throws what `impulse` throws.
std::array<double, impact_conditions> condition_errors(const ReportedImpacts& reported);

/// The first condition whose error is above its bound; none if the outcome is one that is allowed.
std::optional<ImpactCondition> violated(const ReportedImpacts& reported, double allowed);

}  // namespace touchstone::reference
