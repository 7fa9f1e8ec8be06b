// Exact mass properties of solids of uniform density.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/scene.h"
#include "reference/rational.h"

namespace touchstone::reference {

/// Volume (m³), centroid in B (m), and the second moments of volume about the centroid in B's axes (m⁵):
///   inertia of unit density, (Ixx, Iyy, Izz, Ixy, Ixz, Iyz) with Ixy = −∫ x y dV.
/// Polytopes: sums over signed tetrahedra from the origin, exact. The values of a sphere, and of a compound with
/// spheres, contain multiples of π: every value is `rational + pi_multiple·π`.
struct SolidTruth {
  struct Value {
    Rational rational;
    Rational pi_multiple;
    Interval enclosure;  ///< at most a few ulps wide
  };
  Value volume;
  std::array<Value, 3> first_moments;   ///< ∫ x dV, about B's origin
  std::array<Value, 6> second_moments;  ///< inertia of unit density about B's origin, in B's axes
  std::array<Interval, 3> centroid;
  std::array<Interval, 6> inertia;  ///< of unit density, about the centroid
};

/// The moments of one shape, exact up to π. A polytope needs its faces, as reference/validity.h derives them.
SolidTruth solid(const Shape& shape);

/// Enclosures of mass (kg), centre of mass in B (m) and inertia about it in B's axes (kg m²), for one body. Given
/// properties are returned unchanged.
struct MassTruth {
  Interval mass;
  std::array<Interval, 3> p_BBcm;
  std::array<Interval, 6> I_BBcm_B;  ///< xx, yy, zz, xy, xz, yz
};

/// One entry per body, in the scene's order; none for a fixed body. Requires a completed scene (reference/validity.h).
std::vector<std::optional<MassTruth>> mass(const Scene& scene);

/// The middle of each enclosure: one of the two neighbouring doubles.
MassProperties nearest(const MassTruth& truth);

}  // namespace touchstone::reference
