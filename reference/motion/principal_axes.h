// Principal moments of inertia and their axes, enclosed.
#pragma once

#include <gmpxx.h>

#include <array>

#include "reference/exact/linear.h"
#include "reference/exact/tiers.h"

namespace touchstone::reference {

struct PrincipalAxes {
  std::array<WideEnclosure, 3> moments;            ///< ascending
  std::array<Coordinates<WideEnclosure>, 3> axes;  ///< unit vectors in the body's axes; the sign of each is arbitrary
};

/// Requires a symmetric matrix with three different eigenvalues. Wide or NaN where 76 digits hardly distinguish two of
/// them.
PrincipalAxes principal_axes(const Square<mpq_class>& I);

}  // namespace touchstone::reference
