// The exact tight axis-aligned box of each body.
#pragma once

#include <array>
#include <vector>

#include "model/scene.h"
#include "reference/rational.h"

namespace touchstone::reference {

/// The least and the greatest corner of a body's box in W (m). Exact: vertices under R(q/|q|) are rational
/// (reference/exact_pose.h).
struct ExactBox {
  std::array<Rational, 3> lo;
  std::array<Rational, 3> hi;
};

/// The tight box of one body, and those of all bodies in the scene's order (m, in W). Require valid shapes; faces are
/// not needed.
ExactBox box(const Body& body);
std::vector<ExactBox> bounds(const Scene& scene);

}  // namespace touchstone::reference
