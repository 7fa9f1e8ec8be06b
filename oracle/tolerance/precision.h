// A subject's declared precision: its rounding unit, and whether a scene can be passed to it without rounding.
#pragma once

#include "model/scene.h"
#include "oracle/subject.h"

namespace touchstone::oracle {

/// u: a result in range is the true one times (1 + δ), |δ| ≤ u. 2⁻⁵³ or 2⁻²⁴. An exact subject answers in doubles:
/// 2⁻⁵³.
double unit_roundoff(Precision precision);

/// Is every number of the shapes, poses and masses, and of the contact and the velocities if there is a contact, exact
/// in this precision? If not, the subject would get a different question than the oracle, and the property returns
/// `outside`.
bool exact_in(const Scene& scene, Precision precision);

}  // namespace touchstone::oracle
