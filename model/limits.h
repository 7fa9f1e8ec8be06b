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
/// or of two fixed ones; a raster without pixels or with more than 2²⁴. Denormals are legal.
void validate(const Scene& scene);

}  // namespace touchstone
