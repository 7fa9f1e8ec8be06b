// Every shape against every other, with small integers throughout.
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

ConvexShape some_shape(Random& random) {
  switch (random.below(5)) {
    case 0:
      return Sphere{random.whole(1, 4)};
    case 1:
      return Box{Vec3{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)}};
    case 2:
      return block(Vec3{-random.whole(1, 4), -random.whole(1, 4), -random.whole(1, 4)}, Vec3{1, 2, 3});
    case 3:
      return summit(random, some_kind(random));
    default:
      return bipyramid(some_polygon(random), -2, 3);
  }
}

Pose some_pose(Random& random, int limit) {
  const Quaternion q = random.one_in(2) ? Quaternion{} : small_quaternion(random);
  return {small_vector(random, limit), q};
}

Body some_convex_body(Random& random) {
  Shape shape = std::visit([](auto convex) -> Shape { return convex; }, some_shape(random));
  return at_rest(std::move(shape), some_pose(random, 5));
}

Body some_compound(Random& random) {
  Compound compound;
  for (int i = random.between(1, 3); i > 0; --i) {
    const Pose X_BP = some_pose(random, 4);
    compound.parts.push_back({X_BP, some_shape(random)});
  }
  return at_rest(std::move(compound), some_pose(random, 6));
}

Scene shapes(Random& random) {
  Body A = some_convex_body(random);
  return pair(random, std::move(A), some_convex_body(random));
}

Scene compounds(Random& random) {
  Body A = some_compound(random);
  return pair(random, std::move(A), random.one_in(2) ? some_compound(random) : some_convex_body(random));
}

/// Neighbouring parts of a convex decomposition share a plane: two stairs of unit blocks, one step on the other.
Scene stairs(Random& random) {
  const auto stair = [&random](double z) {
    Compound compound;
    for (int i = random.between(2, 4); i > 0; --i) {
      compound.parts.push_back({{Vec3{2.0 * i, 0, z * i}, {}}, Box{Vec3::Ones()}});
    }
    return compound;
  };
  const double z = random.pick({0.0, 2.0, -2.0, 1.0});
  Body A = at_rest(stair(z));
  const Vec3 p{2 * random.whole(-2, 4), random.whole(-2, 2), 2 + dyadic_gap(random, 1, 16)};
  return pair(random, std::move(A), at_rest(stair(z), {p, {}}));
}

}  // namespace

std::vector<Family> mixed_families() {
  return {
      {"mixed.shapes", "sphere, box or polytope against any other, integer poses and quaternions", convex_pair_queries,
       true, shapes},
      {"mixed.compounds", "a compound of one to three parts, which may overlap, against a compound or a convex body",
       pair_queries, true, compounds},
      {"mixed.stairs", "compounds of boxes that share planes, one stair on another", pair_queries, true, stairs},
  };
}

}  // namespace touchstone::properties
