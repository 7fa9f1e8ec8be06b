// Axis-aligned boxes: cases that an engine handles exactly by a special case, or not at all.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

double size(Random& random) { return random.whole(1, 6); }

/// FCL issue 508: its signed distance was wrong for about 40 % of such cubes, and for no uniformly random boxes.
Scene equal_cubes(Random& random) {
  const double half = dyadic(random, 1, 6, -2, 1);
  const double gap = dyadic(random, 0, 8, -8, 0);
  const double side = random.sign();
  Vec3 p = Vec3::Zero();
  p[random.below(3)] = side * 2 * half * (1 + gap);
  const Box cube{Vec3::Constant(half)};
  return pair(random, at_rest(cube), at_rest(cube, {p, {}}));
}

/// The position of B beside A on an axis across the gap: centred, flush on the inside or outside, past it, or anywhere.
double beside(Random& random, double half_A, double half_B) {
  const double past = half_A + half_B + random.whole(1, 3);
  const double side = random.sign();
  return side * random.pick({0.0, half_A - half_B, half_A + half_B, past, random.whole(0, 3)});
}

Scene gap_along_an_axis(Random& random, double gap) {
  const Vec3 A{size(random), size(random), size(random)};
  const Vec3 B = random.one_in(3) ? A : Vec3{size(random), size(random), size(random)};
  Vec3 p{beside(random, A.x(), B.x()), beside(random, A.y(), B.y()), beside(random, A.z(), B.z())};
  const int axis = random.below(3);
  p[axis] = random.sign() * (A[axis] + B[axis] + gap);
  return pair(random, at_rest(Box{A}), at_rest(Box{B}, {p, {}}));
}

Scene axes_turned(Random& random) {
  const Quaternion q = axes_quaternion(random);
  const double half = size(random);
  const double other = size(random);
  const double apart = half + other + dyadic_gap(random, 1, 16);
  const double side = random.sign();
  Vec3 p = Vec3::Zero();
  p[random.below(3)] = side * apart;
  const Body A = at_rest(Box{Vec3::Constant(half)}, {Vec3::Zero(), q});
  return pair(random, A, at_rest(Box{Vec3::Constant(other)}, {p, axes_quaternion(random)}));
}

/// Diagonal neighbours in a lattice of equal boxes: they touch in an edge or a corner.
Scene corner_to_corner(Random& random) {
  const Vec3 half{size(random), size(random), size(random)};
  Vec3 p;
  for (int i = 0; i < 3; ++i) {
    const double gap = random.one_in(4) ? dyadic_gap(random, 1, 16) : 0;
    p[i] = random.sign() * (2 * half[i] + gap);
    if (random.one_in(3)) p[i] = 0;
  }
  if (p.isZero(0)) p.z() = 2 * half.z();
  return pair(random, at_rest(Box{half}), at_rest(Box{half}, {p, {}}));
}

}  // namespace

std::vector<Family> box_families() {
  return {
      {"boxes.equal_cubes", "two equal cubes, not turned, apart along one axis", convex_pair_queries, true,
       equal_cubes},
      {"boxes.dyadic_gap",
       "boxes, not turned, a gap of ±2^-1 to ±2^-18 or 0 along an axis; across it in line, shifted, or past each other",
       convex_pair_queries, true, [](Random& random) { return gap_along_an_axis(random, dyadic_gap(random, 1, 18)); }},
      {"boxes.tiny_gap", "the same with gaps of ±2^-19 to ±2^-48: one rounding and less", convex_pair_queries, false,
       [](Random& random) { return gap_along_an_axis(random, dyadic_gap(random, 19, 48)); }},
      {"boxes.axes_turned", "cubes turned so that axes map to axes, which the quaternion does not show",
       convex_pair_queries, true, axes_turned},
      {"boxes.lattice_neighbours", "equal boxes of a lattice that touch in a face, an edge or a corner",
       convex_pair_queries, true, corner_to_corner},
  };
}

}  // namespace touchstone::properties
