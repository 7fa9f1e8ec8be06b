// Error bounds of a first-order time-stepper against the exact ball, derived in oracle/tolerance/constraint.cpp.
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/subject.h"
#include "reference/constraint.h"

namespace touchstone::oracle::tolerance {

/// s: the step size that is granted to a time-stepper.
double granted_step(const Scene& scene);

/// At one sample.
struct RollingBound {
  double place = 0;      ///< m, of the ball's centre
  double speed = 0;      ///< m/s, of v and of r w
  bool settled = false;  ///< no change is so near that it may be on the other side of the sample
};

/// One bound for each sample, as many as are certain. After these, errors may have grown so large that the ball makes
/// different changes. `step` (s): the step size that is granted.
std::vector<RollingBound> rolling(const Scene& scene, const reference::ConstraintTruth& truth, Precision precision,
                                  double step);

/// m: how deep two bodies may overlap at a sample: as far as one moves in a granted step.
double overlap_of_step(const Scene& scene);

/// m: how deep bodies a and b may in addition, since the places of both are rounded.
double rounding_of_places(const Scene& scene, std::size_t a, std::size_t b, Precision precision);

/// J: upper bound of the rise of the energy of all bodies between two samples.
double energy_of_steps(const Scene& scene);

/// 1: what rounding may change the difference of two energies of all bodies, relative to the sizes of the terms of one.
double rounding_of_energies(Precision precision);

}  // namespace touchstone::oracle::tolerance
