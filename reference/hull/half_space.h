// Convex solids as vertices, edges and half-spaces, in plain rationals.
#pragma once

#include <gmpxx.h>

#include <utility>
#include <vector>

#include "reference/motion/plain_pose.h"

namespace touchstone::reference {

inline Triple plus(const Triple& a, const mpq_class& s, const Triple& b) {
  return {mpq_class(a[0] + s * b[0]), mpq_class(a[1] + s * b[1]), mpq_class(a[2] + s * b[2])};
}
inline Triple minus(const Triple& a, const Triple& b) { return plus(a, -1, b); }

/// normal·p ≤ offset.
struct HalfSpace {
  Triple normal;
  mpq_class offset;
};

struct Segment {
  Triple from, to;
};

/// A polytope or an infinite prism. The edges are given only as far as they are needed.
struct Hull {
  std::vector<Segment> edges;
  std::vector<HalfSpace> sides;
};

}  // namespace touchstone::reference
