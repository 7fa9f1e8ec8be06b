// How far a time-stepper of first order may be from the exact ball, derived in tolerance_constraint.cpp.
#pragma once

#include <vector>

#include "oracle/subject.h"
#include "reference/constraint.h"

namespace touchstone::oracle::tolerance {

/// s: the step that a time-stepper is granted.
double granted_step(const Scene& scene);

/// At one look.
struct RollingBound {
  double place = 0;      ///< m, of the ball's centre
  double speed = 0;      ///< m/s, of v and of r w
  bool settled = false;  ///< no change is so near that it may be on the other side of the look
};

/// By look; as many as are sure. From there on, errors may have grown so that the ball does something else.
std::vector<RollingBound> rolling(const Scene& scene, const reference::ConstraintTruth& truth, Precision precision);

/// m: how deep two bodies may overlap at a look: as far as one comes in a granted step.
double sunk(const Scene& scene);

/// J: by how much the energy of all bodies may rise between two looks.
double energy_of_steps(const Scene& scene);

}  // namespace touchstone::oracle::tolerance
