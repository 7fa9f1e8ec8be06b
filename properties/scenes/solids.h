// Polytopes whose faces are known without computing a hull, most of them on the integer lattice.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/shape.h"
#include "properties/random.h"

namespace touchstone::properties {

using IntMat3 = Eigen::Matrix3i;

/// A strictly convex polygon in the xy plane, counter-clockwise, with integer corners.
using Polygon = std::vector<Eigen::Vector2i>;

/// A polygon of 3 to 8 corners with the origin in its interior and all coordinates within ±4.
Polygon some_polygon(Random& random);

/// All lattice points on the circle x² + y² = n, in order: exactly cocircular. Requires at least 3 such points.
Polygon lattice_circle(int n);

/// The prism over the polygon, from z = lo to z = hi.
Polytope prism(const Polygon& polygon, double lo, double hi);

/// The frustum between the polygon scaled by `bottom` at z = lo and scaled by `top` at z = hi (both factors > 0).
Polytope frustum(const Polygon& polygon, int bottom, double lo, int top, double hi);

/// Base at z = lo, apex at (0, 0, hi).
Polytope pyramid(const Polygon& base, double lo, double hi);

/// Apexes at (0, 0, lo) and (0, 0, hi), lo < 0 < hi, the polygon at z = 0 between: vertices of degree 3 to 8.
Polytope bipyramid(const Polygon& polygon, double lo, double hi);

/// A ridge from (x0, 0, hi) to (x1, 0, hi) over the rectangle [bx0, bx1] × [by0, by1] at z = lo.
Polytope roof(double x0, double x1, double hi, const Vec3& base_lo, const Vec3& base_hi);

/// The hull of four points in any order. They must not be coplanar; exact for integers below 2^16.
Polytope tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The box [lo, hi] as a polytope, with its vertices in the order of model/shape.h.
Polytope block(const Vec3& lo, const Vec3& hi);

/// Every vertex v becomes M v. Requires det M ≠ 0 and no rounding; a reflection reverses the faces' orientation.
Polytope mapped(Polytope polytope, const IntMat3& M);

/// Every vertex v becomes v + t. Requires no rounding.
Polytope shifted(Polytope polytope, const Vec3& t);

/// Adds vertices that are no corners on about half of the edges and faces, at least on one, and puts all vertices in a
/// random order. Halves and quarters of coordinates must be exact.
Polytope with_redundant_vertices(Random& random, Polytope solid);

/// One of the 48 symmetries of the cube.
IntMat3 some_axes(Random& random);

/// Shears along planes of constant z by small integers: (x + a z, y + b z, z).
IntMat3 some_shear(Random& random);

}  // namespace touchstone::properties
