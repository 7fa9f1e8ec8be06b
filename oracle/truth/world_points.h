// The positions of a part's vertices in the world, in long double: for judging, where an error of 2⁻⁶⁴ is far below any
// allowance.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/scene.h"

namespace touchstone::oracle {

using Real = long double;
using Point = Eigen::Matrix<Real, 3, 1>;
using Points = std::vector<Point>;

/// The vertices of a convex part in its own frame; as below.
std::vector<Vec3> own_vertices(const Body& body, int part);

/// The vertices of a convex part in W: a sphere's centre, a box's eight corners in the order of model/shape.h, a
/// polytope's vertices. Empty if the body has no such part (a convex body's only part is 0).
Points world_points(const Body& body, int part);

}  // namespace touchstone::oracle
