// Mass properties in doubles.
#pragma once

#include <optional>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// Mass (kg), centre of mass in B (m), inertia about it in B's axes (kg m²); nothing for a fixed body; given values are
/// returned unchanged.
///
/// Sphere and box: closed forms. Polytope: tetrahedra from a point inside, so that every volume is positive and the
/// sums have no cancellation. With a, b, c relative to that point and d = det(a, b, c),
///   V = Σ d/6,  V p = Σ d (a + b + c)/24,  ∫ x xᵀ dV = Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ)/120, s = a + b + c.
/// A compound is the sum of its parts, moved by Steiner's theorem. Throws InputError for a polytope without faces.
/// Source: Mirtich 1996, "Fast and accurate computation of polyhedral mass properties" (the integrals).
std::optional<MassProperties> mass(const Body& body);

/// Mass properties, and about how far rounding may have moved them from the exact ones.
struct RoundedMass {
  MassProperties properties;
  double mass_error = 0;              ///< of the mass, relative
  Vec3 centre_error = Vec3::Zero();   ///< of p_BBcm, m
  Mat3 inertia_error = Mat3::Zero();  ///< of each entry, kg m²
};

/// As mass(body), with errors; those of given values are 0.
///
/// A polytope's: with h the greatest |coordinates| of its n triangles' corners relative to the point inside, each d is
/// off by about 8u of 6 h₁h₂h₃ and their sum by √n times that, so V by a share r = 16u √n h₁h₂h₃/V; p by 2 r h, and the
/// integral of x_i x_j by V h_i h_j (2r + 8u). Empirical, as the roundings of n terms are added as if they were
/// independent; a sliver that is askew in its axes has a large r.
std::optional<RoundedMass> rounded_mass(const Body& body);

/// One entry per body, in the scene's order.
Masses mass(const Scene& scene);

}  // namespace touchstone::fast
