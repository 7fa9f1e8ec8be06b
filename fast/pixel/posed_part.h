// A convex part in W, rounded, with a bound on all rounding errors of the depth maps.
#pragma once

#include <variant>
#include <vector>

#include "fast/pixel/grid.h"
#include "model/scene.h"

namespace touchstone::fast::pixel {

/// A shape under one pose, or under two, the outer one first.
struct Part {
  std::vector<Pose> poses;
  std::variant<Sphere, Polytope> shape;  ///< a box as a polytope
};

/// The parts of a valid body whose polytopes have their faces.
std::vector<Part> parts_of(const Body& body);

/// `error`: on each axis, each vertex (or centre), each line of the grid, and each point of a face cut by up to four of
/// these lines is within it of its exact counterpart.
struct PosedPart {
  std::vector<Vec3> vertices;  ///< for a sphere, its centre
  double radius = 0;
  double error = 0;
  Aabb box;  ///< contains the part

  bool is_sphere() const { return radius > 0; }
};

/// Throws std::range_error if lengths exceed 2^1000.
PosedPart posed(const Part& part, const Grid& grid);

}  // namespace touchstone::fast::pixel
