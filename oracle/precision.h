// A subject's declared precision: its rounding unit, and which scenes it can be asked without rounding the question.
#pragma once

#include "model/scene.h"
#include "oracle/subject.h"

namespace touchstone::oracle {

/// u: a result in range is the true one times (1 + δ), |δ| ≤ u. 2⁻⁵³ or 2⁻²⁴. An exact subject answers in doubles:
/// 2⁻⁵³.
double unit_roundoff(Precision precision);

/// Does every number of shape, pose and mass, and where there is a contact of it and of the velocities, stand in this
/// precision as it is? If not, the subject would be asked another question than the oracle, and the property says
/// `outside`.
bool exact_in(const Scene& scene, Precision precision);

}  // namespace touchstone::oracle
