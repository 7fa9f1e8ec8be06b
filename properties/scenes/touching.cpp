// Exact contact of every pair of feature kinds in any orientation, then displaced by the smallest amounts possible.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

Pose small_pose(Random& random) {
  const Quaternion q = small_quaternion(random);
  return {random.one_in(2) ? Vec3::Zero() : small_vector(random, 8), q};
}

Scene by_pose(Random& random, double gap) {
  Polytope below = summit(random, some_kind(random));
  Polytope above = depression(random, some_kind(random));
  const Quaternion q = axes_quaternion(random);
  return across_by_pose(random, std::move(below), std::move(above), gap, q);
}

/// ±1, ±1e-15, ±1e-14, …, ±1e-3 of the size, in decimal: not dyadic.
double relative_gap(Random& random) {
  const int sign = random.sign();
  double gap = 1e-3 * random.whole(1, 9) * sign;
  for (int i = random.between(0, 12); i > 0; --i) gap /= 10;
  return gap;
}

/// A few times the spacing of doubles at the size of the bodies, or far below it.
double ulps(Random& random) {
  const int some = random.pick({-4, -3, -2, -1, 1, 2, 3, 4});
  return std::ldexp(some, -random.pick({53, 52, 51, 50, 60, 70, 100, 300}));
}

/// The contact shifted along the common plane, so that the features overlap in part, share a point, or miss.
Scene shifted_contact(Random& random) {
  Polytope below = summit(random, some_kind(random));
  Vec3 shift = small_vector(random, 4);
  shift.z() = 0;
  Polytope above = shifted(depression(random, some_kind(random)), shift);
  const double gap = random.one_in(2) ? 0 : dyadic_gap(random, 1, 12);
  const Pose X = small_pose(random);
  return across(random, std::move(below), std::move(above), gap, X);
}

}  // namespace

std::vector<Family> touching_families() {
  return {
      {"touching.exact", "vertex, edge or face on vertex, edge or face, exactly touching, at any rational rotation",
       convex_pair_queries, true, [](Random& random) { return contact(random, 0, small_pose(random)); }},
      {"touching.dyadic_gap", "the same, apart or overlapping by 2^-1 to 2^-18", convex_pair_queries, true,
       [](Random& random) {
         const double gap = dyadic_gap(random, 1, 18);
         return contact(random, gap, small_pose(random));
       }},
      {"touching.tiny_gap", "the same, apart or overlapping by 2^-19 to 2^-48", convex_pair_queries, false,
       [](Random& random) {
         const double gap = dyadic_gap(random, 19, 48);
         return contact(random, gap, small_pose(random));
       }},
      {"touching.relative_gap", "the same along an axis, apart or overlapping by 1e-15 to 1e-2", convex_pair_queries,
       false, [](Random& random) { return by_pose(random, relative_gap(random)); }},
      {"touching.ulps", "the same along an axis, apart or overlapping by one to four ulps, or by 2^-60 to 2^-300",
       convex_pair_queries, false, [](Random& random) { return by_pose(random, ulps(random)); }},
      {"touching.shifted",
       "features in one plane or 2^-1 to 2^-12 off it, that overlap in part, touch in a point, or miss",
       convex_pair_queries, true, shifted_contact},
  };
}

}  // namespace touchstone::properties
