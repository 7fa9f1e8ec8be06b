// The shapes of bodies. Every shape is a closed point set in its own frame.
#pragma once

#include <variant>
#include <vector>

#include "model/frame.h"

namespace touchstone {

/// All points within `radius` (> 0, m) of the origin.
struct Sphere {
  double radius = 0;

  bool operator==(const Sphere&) const = default;
};

/// |x| ≤ hx, |y| ≤ hy, |z| ≤ hz with half_extents = (hx, hy, hz), each > 0.
/// Vertex i is (±hx, ±hy, ±hz): bits 0, 1, 2 of i set mean + on x, y, z.
struct Box {
  Vec3 half_extents = Vec3::Zero();

  bool operator==(const Box& other) const { return half_extents == other.half_extents; }
};

/// The convex hull of `vertices`, exactly.
///
/// Conditions of a valid polytope: it has volume; no two vertices are equal; every vertex lies on the hull's boundary;
/// `faces` are that boundary: exactly plane polygons, counter-clockwise seen from outside, and each edge belongs to two
/// faces, once in each direction. Coplanar neighbouring faces are allowed. If `faces` is empty, the faces are derived
/// (reference/convex_hull.h).
struct Polytope {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;

  bool operator==(const Polytope&) const = default;
};

using ConvexShape = std::variant<Sphere, Box, Polytope>;

/// One convex part P of a compound, with its pose in the body's frame.
struct Part {
  Pose X_BP;
  ConvexShape shape;

  bool operator==(const Part&) const = default;
};

/// The union of its parts (at least one). Parts may overlap; the mass properties then count the overlap once for each
/// part.
struct Compound {
  std::vector<Part> parts;

  bool operator==(const Compound&) const = default;
};

using Shape = std::variant<Sphere, Box, Polytope, Compound>;

}  // namespace touchstone
