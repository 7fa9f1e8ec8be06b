// Ordinary nearly degenerate pairs, made hard by their position, their size, or the form of their rotation.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

double power_of_two(Random& random, int least, int greatest) {
  return std::ldexp(1.0, random.between(least, greatest));
}

Scene times_a_power_of_two(Random& random, int k) {
  const Scene scene = some_pair(random);
  return *scaled(scene, random.sign() * k);
}

/// The gap is in the bodies' own coordinates, so it loses no digit far away.
Scene far_away(Random& random, const Vec3& t) {
  const double gap = dyadic_gap(random, 1, 18);
  return contact(random, gap, {t, small_quaternion(random)});
}

Scene far_in_floats(Random& random) {
  const double far = power_of_two(random, 10, 20);
  return far_away(random, far * small_vector(random, 8));
}

Scene far_in_doubles(Random& random) {
  double far = 10 * random.unit();
  for (int i = random.between(6, 15); i > 0; --i) far *= 10;
  return far_away(random, Vec3{far, far * random.unit(), -far * random.unit()});
}

Scene size_ratio(Random& random, int least, int greatest) {
  const int factor = 1 << random.between(least, greatest);
  const Kind kind = some_kind(random);
  Polytope below = mapped(summit(random, kind), factor * IntMat3::Identity());
  Polytope above = depression(random, some_kind(random));
  const double gap = dyadic_gap(random, 0, 16);
  return across(random, std::move(below), std::move(above), gap, {Vec3::Zero(), small_quaternion(random)});
}

/// w is 0 or small compared with the rest: rotations by 120° to 180°, whose matrices are far from the identity.
Scene beyond_90(Random& random) {
  Quaternion q = small_quaternion(random);
  if (q.x == 0 && q.y == 0 && q.z == 0) q.x = 1;
  q.w = random.one_in(2) ? 0 : power_of_two(random, -12, -1);
  const double gap = dyadic_gap(random, 1, 18);
  return contact(random, gap, {Vec3::Zero(), q});
}

/// Rotations by 2^-21 to 2^-7 rad: sines that a single epsilon rounds to 0.
Scene near_identity(Random& random) {
  const Quaternion q{power_of_two(random, 8, 20), random.whole(-1, 1), random.whole(-1, 1), 1};
  const double gap = dyadic_gap(random, 1, 18);
  return contact(random, gap, {Vec3::Zero(), q});
}

void multiply(Quaternion& q, double s) { q = {s * q.w, s * q.x, s * q.y, s * q.z}; }

Scene not_unit(Random& random, int least, int greatest) {
  Scene scene = some_pair(random);
  for (Body& body : scene.bodies) {
    const double s = random.sign();
    multiply(body.X_WB.q_WB, s * power_of_two(random, least, greatest));
  }
  return scene;
}

}  // namespace

std::vector<Family> placed_families() {
  return {
      {"scale.2_20", "a small pair times 2^20 or 2^-20", convex_pair_queries, true,
       [](Random& random) { return times_a_power_of_two(random, 20); }},
      {"scale.2_40",
       "a small pair times 2^40 or 2^-40",
       {"bounds", "broad_phase", "distance", "penetration"},
       true,
       [](Random& random) { return times_a_power_of_two(random, 40); }},
      {"scale.2_60",
       "a small pair times 2^60 or 2^-60",
       {"bounds", "broad_phase", "distance", "penetration"},
       true,
       [](Random& random) { return times_a_power_of_two(random, 60); }},
      {"scale.2_500",
       "a small pair times 2^500 or 2^-500: sums are safe, products of three lengths are not",
       {"bounds", "broad_phase"},
       false,
       [](Random& random) { return times_a_power_of_two(random, 500); }},
      {"far.floats", "touching or nearly, 2^10 to 2^23 from the origin", convex_pair_queries, true, far_in_floats},
      {"far.doubles", "touching or nearly, 1e6 to 1e16 from the origin", convex_pair_queries, false, far_in_doubles},
      {"ratio.to_2_20", "touching or nearly, one up to 2^20 times as large as the other", convex_pair_queries, true,
       [](Random& random) { return size_ratio(random, 1, 20); }},
      {"ratio.to_2_28",
       "touching or nearly, one 2^21 to 2^28 times as large as the other",
       {"bounds", "broad_phase", "distance", "penetration"},
       true,
       [](Random& random) { return size_ratio(random, 21, 28); }},
      {"turn.beyond_90", "touching or nearly, turned by 120° to 180°", convex_pair_queries, true, beyond_90},
      {"turn.near_identity", "touching or nearly, turned by 2^-7 to 2^-20 rad", convex_pair_queries, true,
       near_identity},
      {"turn.not_unit", "a small pair, its quaternions 2^-60 to 2^60 long, of either sign", convex_pair_queries, true,
       [](Random& random) { return not_unit(random, -60, 60); }},
      {"turn.far_from_unit", "a small pair, its quaternions 2^-400 to 2^400 long", convex_pair_queries, false,
       [](Random& random) { return not_unit(random, -400, 400); }},
  };
}

}  // namespace touchstone::properties
