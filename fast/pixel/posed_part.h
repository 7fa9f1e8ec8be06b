// A convex part in W, rounded, with a bound on all that rounding does to it here.
#pragma once

#include <variant>
#include <vector>

#include "fast/pixel/grid.h"
#include "model/scene.h"

namespace touchstone::fast::pixels {

/// A shape under one pose, or under two, the outer one first.
struct Part {
  std::vector<Pose> poses;
  std::variant<Sphere, Polytope> shape;  ///< a box as a polytope
};

/// Of a valid body whose polytopes have their faces.
std::vector<Part> parts_of(const Body& body);

/// `error`: each vertex (or centre), each line of the grid, and each point of a face cut by up to four of these lines
/// is within it of what it stands for, on each axis.
struct PosedPart {
  std::vector<Vec3> vertices;  ///< of a sphere the centre
  double radius = 0;
  double error = 0;
  Aabb box;  ///< holds the part

  bool is_sphere() const { return radius > 0; }
};

/// Throws std::range_error if lengths are beyond 2^1000.
PosedPart posed(const Part& part, const Grid& grid);

}  // namespace touchstone::fast::pixels
