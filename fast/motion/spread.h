// Volume, centroid and second moments of a solid at unit density.
#pragma once

#include <array>

#include "fast/exact/dyadic.h"
#include "model/frame.h"
#include "model/shape.h"

namespace touchstone::fast::motion {

/// Volume V, centroid c, and C = ∫ (x − c)(x − c)ᵀ dV, in the solid's frame; C has an error of at most `error`
/// (Frobenius norm).
struct Spread {
  double volume = 0;
  Vec3 centroid = Vec3::Zero();
  Mat3 C = Mat3::Zero();
  double error = 0;
};

using ExactMatrix = std::array<std::array<exact::Dyadic, 3>, 3>;

struct ExactSpread {
  Spread rounded;        ///< each number is its exact value, rounded
  ExactMatrix scaled_C;  ///< C times a positive number, exactly: equal moments are equal
};

/// Throws InputError for a polytope without faces, or of no positive volume. Cost: some 100 exact operations a
/// triangle.
ExactSpread exact_spread(const Polytope& polytope);

}  // namespace touchstone::fast::motion
