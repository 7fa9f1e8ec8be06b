// What a valid scene is, as far as floating point alone can tell; reference/validity.h adds what needs exact
// arithmetic.
#pragma once

#include "model/scene.h"

namespace touchstone {

/// Throws InputError naming the first place that breaks a law: a number that is not finite, a zero quaternion (any
/// other finite one is legal, however small: the reference divides exactly), a radius or half extent ≤ 0, fewer than 4
/// vertices, equal vertices, a face index out of range, a face with < 3 or repeated vertices, mass or density ≤ 0, an
/// inertia that is not symmetric positive definite or breaks the triangle inequality, e outside [0, 1], mu < 0, no
/// parts; in a film: a body that does not exist, stands twice in a frame, or is taken away without being there; a
/// contact whose normal has not length 1 within rounding, with e or mu out of range, of fewer or more than two bodies
/// or of two fixed ones; a raster without pixels or with more than 2²⁴; a flight without times, with times that do not
/// ascend or are not above 0, an envelope that is not above 0 or not below a thousandth of the size of a body that moves,
/// a push of nobody, of a fixed body, before 0, out of order, or stronger than the flight's bound. Denormals are legal.
void validate(const Scene& scene);

/// Half the least side of the shape's own bounding box; of a compound, the least of its parts' (m).
double size(const Shape& shape);

/// How near counts as contact (m): the flight's envelope, or 2⁻³⁰ of the least size among bodies that are not fixed (0
/// if all are).
double envelope(const Scene& scene);

}  // namespace touchstone
