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

SolidTruth solid(const Shape& shape);

/// Enclosures of mass, centre of mass and inertia about it, for one body; none for a fixed body. Given properties are
/// returned unchanged.
struct MassTruth {
  Interval mass;
  std::array<Interval, 3> p_BBcm;
  std::array<Interval, 6> I_BBcm_B;  ///< xx, yy, zz, xy, xz, yz
};

std::vector<std::optional<MassTruth>> mass(const Scene& scene);

/// The middle of each enclosure: one of the two neighbouring doubles.
MassProperties nearest(const MassTruth& truth);

}  // namespace touchstone::reference
