// The conditions of a valid scene that need only floating point; reference/validity.h checks those that need exact
// arithmetic.
#pragma once

#include "model/scene.h"

namespace touchstone {

/// Throws InputError naming the first place that breaks a condition. Refused are:
/// - a number that is not finite; denormals are legal;
/// - a zero quaternion; any other finite one is legal, however small, since the reference divides exactly;
/// - a radius or half extent ≤ 0; fewer than 4 vertices; equal vertices; a face index out of range; a face with fewer
///   than 3 vertices or with a repeated one; a compound without parts;
/// - mass or density ≤ 0; an inertia that is not symmetric positive definite or breaks the triangle inequality; e
///   outside [0, 1]; mu < 0;
/// - in a sequence: a body that does not exist, is placed twice in a frame, or is removed while it is absent;
/// - a contact with a normal whose length is not 1 within rounding, with e or mu out of range, in a scene of fewer or
///   more than two bodies, or of two fixed ones;
/// - a raster without pixels or with more than 2²⁴;
/// - a motion without sample times, with sample times that are not ascending or not above 0, with an envelope that is
///   not above 0 or not below a thousandth of the size of each body that is not fixed, or with an applied force on a
///   body that does not exist or is fixed, before time 0, out of order, or stronger than the motion's bound.
void validate(const Scene& scene);

/// Half the shortest side of the shape's own bounding box; for a compound, the least value of its parts (m).
double size(const Shape& shape);

/// The distance (m) up to which bodies count as in contact: the motion's envelope, or 2⁻³⁰ of the least size among the
/// bodies that are not fixed (0 if all are fixed).
double envelope(const Scene& scene);

}  // namespace touchstone
