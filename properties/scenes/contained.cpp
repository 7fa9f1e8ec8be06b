// One body inside the other, or both identical: all directions tie, and the penetration is deep.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

/// A solid that contains the origin.
Polytope around_origin(Random& random) {
  const Polygon polygon = some_polygon(random);
  const double lo = -random.whole(1, 4);
  const double hi = random.whole(1, 4);
  const Polytope solid = random.one_in(2) ? bipyramid(polygon, lo, hi) : prism(polygon, lo, hi);
  return mapped(solid, some_axes(random));
}

Scene identical(Random& random) {
  const Polytope solid = around_origin(random);
  const Pose X{small_vector(random, 4), small_quaternion(random)};
  return pair(random, at_rest(solid, X), at_rest(solid, X));
}

/// The same solid in another representation: a box as a polytope, q as −q or 2q, the vertices in another order.
Scene coincident(Random& random) {
  const Vec3 half{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
  const Quaternion q = small_quaternion(random);
  const double s = random.pick({-1.0, 2.0, -0.5, 1.0});
  const Vec3 p = small_vector(random, 4);
  return pair(random, at_rest(Box{half}, {p, q}),
              at_rest(block(-half, half), {p, {s * q.w, s * q.x, s * q.y, s * q.z}}));
}

Scene concentric(Random& random) {
  Polytope inner = around_origin(random);
  const Polytope other = random.one_in(2) ? inner : around_origin(random);
  const Polytope outer = mapped(other, random.between(1, 8) * IntMat3::Identity());
  const Pose X_inner{Vec3::Zero(), small_quaternion(random)};
  const Pose X_outer{Vec3::Zero(), random.one_in(2) ? X_inner.q_WB : small_quaternion(random)};
  return pair(random, at_rest(std::move(inner), X_inner), at_rest(outer, X_outer));
}

Scene concentric_spheres(Random& random) {
  const Vec3 p = small_vector(random, 4);
  const double radius = dyadic(random, 1, 8, -2, 2);
  const Polytope solid = around_origin(random);
  Body other = at_rest(solid, {p, small_quaternion(random)});
  if (random.one_in(3)) other.shape = Sphere{dyadic(random, 1, 8, -2, 2)};
  return pair(random, at_rest(Sphere{radius}, {p, {}}), std::move(other));
}

/// A corner, the middle of an edge, or a point inside a face: exact.
Vec3 on_surface(Random& random, const Polytope& solid) {
  const std::vector<int>& face = solid.faces[random.index(solid.faces.size())];
  const auto corner = [&](std::size_t k) -> const Vec3& { return solid.vertices[static_cast<std::size_t>(face[k])]; };
  switch (random.below(3)) {
    case 0:
      return corner(0);
    case 1:
      return (corner(0) + corner(1)) / 2;
    default:
      return (corner(0) + 2 * corner(1) + corner(2)) / 4;
  }
}

/// A ball whose centre is on the surface of a solid but for the rounding of both places, 1 to 2^38 from the origin.
Scene centre_nearly_on_surface(Random& random, const Polytope& solid, const Vec3& centre) {
  const double far = std::ldexp(1.0, random.one_in(2) ? random.between(0, 12) : random.between(13, 38));
  const auto number = [&random] { return 0.5 + random.unit() / 2; };
  const Vec3 place{number(), number(), number()};
  const Quaternion q{random.sign() * number(), random.sign() * number(), random.sign() * number(), number()};
  const Vec3 p_WS = far * place;
  const double radius = dyadic(random, 1, 8, -2, 2);
  return pair(random, at_rest(solid, {p_WS, q}), at_rest(Sphere{radius}, {p_WS + turned_by(q, centre), {}}));
}

/// A ball whose centre is on the surface of a solid, or 2^-1 to 2^-50 off along an axis.
Scene centre_on_surface(Random& random) {
  const Polytope solid = around_origin(random);
  Vec3 centre = on_surface(random, solid);
  if (random.one_in(2)) return centre_nearly_on_surface(random, solid, centre);
  if (random.one_in(2)) centre[random.below(3)] += dyadic_gap(random, 1, 50);
  const Quaternion q = axes_quaternion(random);
  const double radius = dyadic(random, 1, 8, random.one_in(4) ? -20 : -2, 2);
  return pair(random, at_rest(solid, {Vec3::Zero(), q}), at_rest(Sphere{radius}, {turned_by_axes(q, centre), {}}));
}

/// A small block in a large one, against one of its walls, edges or corners from inside, or slightly through.
Scene nested(Random& random) {
  const Vec3 large{8, random.whole(6, 9), random.whole(6, 9)};
  const Vec3 small{random.whole(1, 3), random.whole(1, 3), random.whole(1, 3)};
  Vec3 at = small_vector(random, 1);
  for (int i = 0; i < 3; ++i) {
    if (random.one_in(2)) at[i] = large[i] - small[i];
  }
  at[random.below(3)] += dyadic_gap(random, 1, 16);
  const Pose X{Vec3::Zero(), small_quaternion(random)};
  return pair(random, at_rest(block(-large, large), X), at_rest(block(at - small, at + small), X));
}

/// Overlaps of any depth: equal blocks that interpenetrate along an axis.
Scene pushed_in(Random& random) {
  const Vec3 size{4, random.whole(2, 6), random.whole(2, 6)};
  const Vec3 shift{dyadic(random, 1, 15, -14, -2), random.whole(-1, 1), random.whole(-1, 1)};
  const Pose X{Vec3::Zero(), small_quaternion(random)};
  return pair(random, at_rest(block(-size, size), X), at_rest(block(shift - size, shift + size), X));
}

}  // namespace

std::vector<Family> contained_families() {
  return {
      {"contained.identical", "the same solid twice in the same place", convex_pair_queries, true, identical},
      {"contained.coincident", "the same solid twice, described in two ways", convex_pair_queries, true, coincident},
      {"contained.concentric", "two solids about one centre, one up to eight times as large", convex_pair_queries, true,
       concentric},
      {"contained.concentric_spheres", "a sphere about the origin of another body", convex_pair_queries, true,
       concentric_spheres},
      {"contained.centre_on_surface", "a ball with its centre on another body's surface, or nearly",
       convex_pair_queries, false, centre_on_surface},
      {"contained.nested",
       "a small block in a large one, at a wall, an edge or a corner from inside, or just through it",
       convex_pair_queries, true, nested},
      {"contained.pushed_in", "equal blocks in each other at any depth", convex_pair_queries, true, pushed_in},
  };
}

}  // namespace touchstone::properties
