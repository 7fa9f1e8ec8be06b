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

/// One entry per body, in the scene's order.
Masses mass(const Scene& scene);

}  // namespace touchstone::fast
