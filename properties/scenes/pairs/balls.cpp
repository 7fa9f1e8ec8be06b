// Balls that touch exactly although the sum of their radii is not a double, or miss that by one ulp of a radius.
#include <cmath>
#include <utility>

#include "model/infinity.h"
#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

/// An odd number of so many bits, between 1 and 2: all of the bits count.
double odd(Random& random, int bits) {
  const double leading = std::floor(std::ldexp(random.unit(), bits - 2));
  return 1 + std::ldexp(2 * leading + 1, 1 - bits);
}

/// The centres are −s d and t d for a lattice vector d of whole length, the radii s |d| and t |d|.
Scene odd_sums(Random& random) {
  const Vec3 d = random.pick<Vec3>({{1, 0, 0}, {0, 1, 0}, {3, 4, 0}, {0, 4, 3}, {1, 2, 2}, {2, 3, 6}, {6, -2, 3}});
  const double length = d.norm();  // a square root of a square: exact
  const int bits = length == 1 ? 53 : 50;
  const double s = odd(random, bits);
  const int down = random.between(1, 60);
  const double t = std::ldexp(odd(random, bits), -down);
  const int more = random.pick({-1, 0, 0, 1});
  double radius = t * length;
  if (more != 0) radius = std::nextafter(radius, more * infinity);
  return pair(random, at_rest(Sphere{s * length}, {-s * d, small_quaternion(random)}),
              at_rest(Sphere{radius}, {t * d, {}}));
}

}  // namespace

std::vector<Family> ball_pair_families() {
  return {{"spheres.odd_sums", "balls whose radii add to no double, touching exactly or one ulp off",
           convex_pair_queries, false, odd_sums}};
}

}  // namespace touchstone::properties
