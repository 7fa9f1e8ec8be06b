// Balls that touch exactly although the sum of their radii is not a double, or miss that by one ulp of a radius; and
// balls of which no number is short, apart or overlapping by a few ulps and less.
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

/// The radii add to the distance of the centres, up to its rounding and eight ulps: the gap is the root of no short
/// number.
Scene within_ulps(Random& random) {
  const auto any = [&random] { return 2 * random.unit() - 1; };
  const Vec3 p_A{any(), any(), any()}, p_B{any(), any(), any()};
  const double distance = (p_B - p_A).norm(), share = random.unit();
  const double radius = std::ldexp(share * distance, -random.between(1, 12));
  double other = distance - radius;
  const double towards = random.one_in(4) ? infinity : 0;
  for (int ulps = random.between(0, 8); ulps > 0; --ulps) other = std::nextafter(other, towards);
  return pair(random, at_rest(Sphere{radius}, {p_A, small_quaternion(random)}), at_rest(Sphere{other}, {p_B, {}}));
}

}  // namespace

std::vector<Family> ball_pair_families() {
  return {{"spheres.odd_sums", "balls whose radii add to no double, touching exactly or one ulp off",
           convex_pair_queries, false, odd_sums},
          {"spheres.within_ulps", "balls with all bits, apart or overlapping by 0 to 8 ulps and a part of one",
           convex_pair_queries, false, within_ulps}};
}

}  // namespace touchstone::properties
