// Two bodies placed without rounding: on both sides of the plane z = 0 of a common frame, which is then rotated as a
// whole.
//
// C++ leaves the order of evaluation of arguments and operands open. So no expression here may draw twice, or compilers
// would make different scenes. (Within braces the order is fixed.)
#pragma once

#include "model/scene.h"
#include "properties/random.h"
#include "properties/scenes/solids.h"

namespace touchstone::properties {

enum class Kind { vertex, edge, face };

Kind some_kind(Random& random);

/// A solid in z ≤ 0 whose highest feature is of the given kind, lies at z = 0 and contains the origin; an edge is along
/// x.
Polytope summit(Random& random, Kind kind);

/// The same in z ≥ 0, with its lowest feature at z = 0.
Polytope depression(Random& random, Kind kind);

Body at_rest(Shape shape, const Pose& X_WB = {});

/// A and B in random order.
Scene pair(Random& random, Body A, Body B);

/// q r: first r, then q. Exact for small integers.
Quaternion times(const Quaternion& q, const Quaternion& r);

/// Integer components in ±3, not all zero: any rotation angle, usually |q| ≠ 1.
Quaternion small_quaternion(Random& random);

/// One of the rotations that map the axes to axes, by integer components in ±1.
Quaternion axes_quaternion(Random& random);

/// A rotation about z by a rational angle: (w, 0, 0, z) with small integers.
Quaternion twist(Random& random);

/// The point p rotated by a quaternion of axes_quaternion: exact.
Vec3 turned_by_axes(const Quaternion& q, const Vec3& p);

/// The point p rotated by any quaternion, each coordinate rounded once, if its numbers and those of q are of few bits.
Vec3 turned_by(const Quaternion& q, const Vec3& p);

/// `below` (in z ≤ 0) and `above` (in z ≥ 0), both in the frame X, with `above` raised by `gap` in its own coordinates:
/// exact for any rotation. Requires that z + gap is exact for each of its vertices.
Scene across(Random& random, Polytope below, Polytope above, double gap, const Pose& X,
             const Quaternion& twist_below = {}, const Quaternion& twist_above = {});

/// The same, but `above` is raised by its pose, so that any double can be the gap. X.q must be of axes_quaternion, and
/// X.p 0.
Scene across_by_pose(Random& random, Polytope below, Polytope above, double gap, const Quaternion& q);

/// A summit and a depression of random kinds, placed by across() with a twist each.
Scene contact(Random& random, double gap, const Pose& X);

/// An integer from lo to hi, times 2^e with e from least to greatest.
double dyadic(Random& random, int lo, int hi, int least, int greatest);

/// A vector of integers in ±`limit`.
Vec3 small_vector(Random& random, int limit);

/// A vector of numbers with all bits, in ±`limit`.
Vec3 any_vector(Random& random, double limit);

/// ±2^-k with k from `least` to `greatest`; 0 with probability 1/4.
double dyadic_gap(Random& random, int least, int greatest);

}  // namespace touchstone::properties
