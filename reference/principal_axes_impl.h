// Principal moments of inertia and their axes, enclosed.
#pragma once

#include <gmpxx.h>

#include <array>

#include "reference/linear_impl.h"
#include "reference/tiers_impl.h"

namespace touchstone::reference {

struct PrincipalAxes {
  std::array<WideEnclosure, 3> moments;            ///< rising
  std::array<Coordinates<WideEnclosure>, 3> axes;  ///< unit, in the body's axes; each in one of its two directions
};

/// Of a symmetric matrix with three different eigenvalues; wide, or no numbers, where 76 digits hardly tell two of them
/// apart.
PrincipalAxes principal_axes(const Square<mpq_class>& I);

}  // namespace touchstone::reference
