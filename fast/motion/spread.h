// Volume, centroid and second moments of a solid at unit density.
#pragma once

#include <array>

#include "fast/exact/vector.h"
#include "model/frame.h"
#include "model/shape.h"

namespace touchstone::fast::motion {

/// Volume V, centroid c, and C = ∫ (x − c)(x − c)ᵀ dV, in the solid's frame.
struct Spread {
  double volume = 0;
  Vec3 centroid = Vec3::Zero();
  Mat3 C = Mat3::Zero();
};

using ExactMatrix = std::array<std::array<exact::Dyadic, 3>, 3>;
ExactMatrix entries(const std::array<exact::Vector, 3>& rows);
exact::Dyadic trace(const ExactMatrix& M);
/// A M Aᵀ.
ExactMatrix congruent(const ExactMatrix& A, const ExactMatrix& M);

/// C times a positive number, so that equal moments are equal.
struct ScaledC {
  ExactMatrix C;
  double error = 0;  ///< of each entry, as a share of the trace of C; 0: exact
};

struct ExactSpread {
  Spread rounded;  ///< each number is its exact value, rounded
  ScaledC scaled;  ///< exact
};

/// Throws InputError for a polytope without faces, or of no positive volume. Cost: some 100 exact operations a
/// triangle.
ExactSpread exact_spread(const Polytope& polytope);

/// Exact for a compound whose parts are all balls, or none is and each |q|² is a power of two (and neither above 2^64
/// nor below 2^-64). Else 1/|q|² and π have errors of 2^-200 of themselves, and `error` is 2^-195 of the sum of the
/// magnitudes of all terms. Throws InputError as above.
ScaledC scaled_spread(const Compound& compound);

}  // namespace touchstone::fast::motion
