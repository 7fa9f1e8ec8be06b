// Needles and plates, up to a ratio of 2^20 (about a million).
#include <array>
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

IntMat3 stretched(int x, int y, int z) { return Eigen::Vector3i(x, y, z).asDiagonal(); }

/// Elongated along the common plane (with the touching edge or face), or perpendicular to it.
IntMat3 needle(Random& random) {
  const int k = 1 << random.between(4, 20);
  return random.pick({stretched(k, 1, 1), stretched(1, k, 1), stretched(1, 1, k)});
}

IntMat3 plate(Random& random) {
  const int k = 1 << random.between(4, 20);
  return random.pick({stretched(k, k, 1), stretched(k, 1, k), stretched(1, k, k)});
}

IntMat3 plain(Random&) { return IntMat3::Identity(); }

/// Stretching leaves the plane z = 0 and the origin unchanged, where the two bodies touch. The lower body stays in
/// place, so only the coordinates of the upper one must represent the gap.
Scene stretched_contact(Random& random, IntMat3 (*stretch_below)(Random&), IntMat3 (*stretch_above)(Random&)) {
  Polytope below = summit(random, some_kind(random));
  below = mapped(std::move(below), stretch_below(random));
  Polytope above = depression(random, some_kind(random));
  above = mapped(std::move(above), stretch_above(random));
  const bool upright = above.vertices.back().z() > 16 || above.vertices.front().z() > 16;
  const double gap = upright ? random.pick({0.0, 0.5, -0.5, 2.0, -2.0}) : dyadic_gap(random, 0, 16);
  Pose X;
  if (random.one_in(2)) X.q_WB = small_quaternion(random);
  const Quaternion turn = random.one_in(2) ? Quaternion{} : twist(random);
  return across(random, std::move(below), std::move(above), gap, X, {}, turn);
}

Scene thin_boxes(Random& random) {
  const auto extent = [&random] { return random.one_in(2) ? random.whole(1, 3) : dyadic(random, 1, 3, -10, 10); };
  const std::array<Vec3, 2> half = {Vec3{extent(), extent(), extent()}, Vec3{extent(), extent(), extent()}};
  const int axis = random.below(3);
  Vec3 p = Vec3::Zero();
  p[axis] = half[0][axis] + half[1][axis];
  const Quaternion q = random.one_in(2) ? Quaternion{} : small_quaternion(random);
  return pair(random, at_rest(Box{half[0]}), at_rest(Box{half[1]}, {p, q}));
}

/// The point of the box that is farthest along n.
Vec3 farthest(const Vec3& half, const Vec3& n) {
  Vec3 corner = half;
  for (int i = 0; i < 3; ++i) corner[i] = std::copysign(half[i], n[i]);
  return corner;
}

/// A needle 2^11 to 2^14 times as long as thick across a box, whose corner is 2^-8 to 2^-20 in its side.
Scene crossing(Random& random) {
  const Vec3 needle{1, std::ldexp(1.0, random.between(11, 14)), 1};
  const Vec3 half{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
  const Quaternion q = times({0, 1, 2, 3}, small_quaternion(random));  // of many bits
  const double side = random.sign();
  const Vec3 n = turned_by(q, {0, 0, side}), along = turned_by(q, {0, 1, 0}), across = turned_by(q, {1, 0, 0});
  const double deep = std::ldexp(1.0, -random.between(8, 20));
  const double up = random.whole(-8, 8), beside = 0.25 * random.whole(-3, 3);
  const Vec3 p = farthest(half, n) + (1 - deep) * n + up * along + beside * across;
  return pair(random, at_rest(Box{half}), at_rest(Box{needle}, {p, q}));
}

}  // namespace

std::vector<Family> slender_families() {
  return {
      {"slender.needles", "touching or nearly, both 2^4 to 2^20 times as long as thick", convex_pair_queries, true,
       [](Random& random) { return stretched_contact(random, needle, needle); }},
      {"slender.plates", "touching or nearly, both 2^4 to 2^20 times as wide as thick", convex_pair_queries, true,
       [](Random& random) { return stretched_contact(random, plate, plate); }},
      {"slender.needle_on_plate", "a needle on a plate or on a solid of ordinary shape", convex_pair_queries, true,
       [](Random& random) { return stretched_contact(random, random.one_in(2) ? plate : plain, needle); }},
      {"slender.boxes", "boxes whose half extents differ by up to 2^20, side by side or turned", convex_pair_queries,
       true, thin_boxes},
      {"slender.crossing", "a long needle across a box whose corner is 2^-8 to 2^-20 in its side", convex_pair_queries,
       false, crossing},
  };
}

}  // namespace touchstone::properties
