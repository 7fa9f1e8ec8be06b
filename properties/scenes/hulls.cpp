// Hulls of random points: with few bits, so that features often coincide, and with full mantissas, so that nothing
// does.
#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <utility>

#include "model/input_error.h"
#include "oracle/truth/truth.h"
#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

Polytope lattice_tetrahedron(Random& random) {
  for (;;) {
    const Vec3 a = small_vector(random, 4), b = small_vector(random, 4);
    const Vec3 c = small_vector(random, 4), d = small_vector(random, 4);
    if ((b - a).cross(c - a).dot(d - a) != 0) return tetrahedron(a, b, c, d);
  }
}

template <class Point>
Polytope hull_of(int count, Point&& point) {
  for (;;) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back(point());
    try {
      return oracle::truth::convex_hull(points);
    } catch (const InputError&) {
      // coplanar: draw again
    }
  }
}

Polytope lattice_hull(Random& random) {
  return hull_of(random.between(5, 10), [&random] { return small_vector(random, 4); });
}

Polytope generic_hull(Random& random, int bits) {
  const auto number = [&random, bits] {
    return std::floor(std::ldexp(random.unit(), bits)) * std::ldexp(2.0, -bits) - 1;
  };
  return hull_of(random.between(4, 16), [&number] { return Vec3{number(), number(), number()}; });
}

Quaternion generic_quaternion(Random& random, int bits) {
  const auto number = [&random, bits] {
    return std::floor(std::ldexp(random.unit(), bits)) * std::ldexp(2.0, -bits) - 1;
  };
  Quaternion q{number(), number(), number(), number()};
  if (q == Quaternion{0, 0, 0, 0}) q.w = 1;
  return q;
}

template <class Solid>
Scene turned_at_random(Random& random, Solid&& solid) {
  Polytope A = solid();
  Polytope B = solid();
  const Pose X_WA{Vec3::Zero(), small_quaternion(random)};
  const Pose X_WB{small_vector(random, 7), random.one_in(2) ? X_WA.q_WB : small_quaternion(random)};
  return pair(random, at_rest(std::move(A), X_WA), at_rest(std::move(B), X_WB));
}

Scene generic(Random& random, int bits) {
  Polytope A = generic_hull(random, bits);
  Polytope B = generic_hull(random, bits);
  const auto number = [&random, bits] {
    return std::floor(std::ldexp(random.unit(), bits)) * std::ldexp(4.0, -bits) - 2;
  };
  const Pose X_WA{Vec3::Zero(), generic_quaternion(random, bits)};
  const Vec3 p{number(), number(), number()};
  return pair(random, at_rest(std::move(A), X_WA), at_rest(std::move(B), {p, generic_quaternion(random, bits)}));
}

/// Apex on apex, or beside it. The apex has as many neighbours as the polygon has corners.
Scene high_degree(Random& random) {
  const auto spike = [&random] {
    const Polygon ring = random.one_in(4) ? lattice_circle(random.pick({5, 25, 65})) : some_polygon(random);
    const double hi = random.whole(1, 9);
    return shifted(bipyramid(ring, -random.whole(1, 9), hi), {0, 0, -hi});
  };
  Polytope below = spike();
  Polytope above = mapped(spike(), Eigen::Vector3i(1, 1, -1).asDiagonal());
  const Vec3 shift{random.whole(-1, 1), random.whole(-1, 1), 0};
  const double gap = dyadic_gap(random, 0, 16);
  const Pose X{Vec3::Zero(), small_quaternion(random)};
  const Quaternion turn = random.one_in(2) ? Quaternion{} : twist(random);
  return across(random, std::move(below), shifted(std::move(above), shift), gap, X, {}, turn);
}

}  // namespace

std::vector<Family> hull_families() {
  return {
      {"hulls.lattice_tetrahedra", "tetrahedra with integer corners in ±4, by integer shifts and quaternions",
       convex_pair_queries, true,
       [](Random& random) { return turned_at_random(random, [&random] { return lattice_tetrahedron(random); }); }},
      {"hulls.lattice", "hulls of 5 to 10 lattice points in ±4: coplanar quadruples, shared planes",
       convex_pair_queries, true,
       [](Random& random) { return turned_at_random(random, [&random] { return lattice_hull(random); }); }},
      {"hulls.generic_floats", "hulls of 4 to 16 random points, every number a random float", convex_pair_queries, true,
       [](Random& random) { return generic(random, 24); }},
      {"hulls.generic", "hulls of 4 to 16 random points, every number a random double", convex_pair_queries, false,
       [](Random& random) { return generic(random, 53); }},
      {"hulls.high_degree", "apexes with 3 to 16 neighbours on or beside each other", convex_pair_queries, true,
       high_degree},
  };
}

}  // namespace touchstone::properties
