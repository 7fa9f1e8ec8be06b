// Many bodies at once: coincident end points, boxes that barely touch, different sizes.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

/// 2 to 40, usually few.
int some_count(Random& random) { return random.one_in(8) ? random.between(17, 40) : random.between(2, 12); }

template <class MakeBody>
Scene crowd(Random& random, MakeBody&& make_body) {
  Scene scene;
  for (int i = some_count(random); i > 0; --i) scene.bodies.push_back(make_body());
  return scene;
}

/// Unit cells of a lattice: neighbours share a face, an edge or a corner.
Scene touching_boxes(Random& random) {
  const double half = dyadic(random, 1, 3, -3, 3);
  return crowd(random, [&] { return at_rest(Box{Vec3::Constant(half)}, {2 * half * small_vector(random, 2), {}}); });
}

/// Unit cells of a lattice with sides too short or too long by 2^-20: shows boxes that are too tight or too loose.
Scene nearly_touching_boxes(Random& random) {
  return crowd(random, [&random] {
    const Vec3 half = Vec3::Ones() + 0x1p-20 * small_vector(random, 1);
    return at_rest(Box{half}, {2 * small_vector(random, 2), {}});
  });
}

/// End points with only a few different values: sorting must not lose a pair in a tie.
Scene equal_ends(Random& random) {
  return crowd(random, [&random] {
    const Vec3 lo = small_vector(random, 2);
    const Vec3 size{random.whole(1, 2), random.whole(1, 2), random.whole(1, 2)};
    return at_rest(block(lo, lo + size));
  });
}

Scene identical_boxes(Random& random) {
  const Body body = at_rest(Box{Vec3{1, 2, 3}}, {small_vector(random, 9), small_quaternion(random)});
  return crowd(random, [&body] { return body; });
}

Scene size_ratio(Random& random) {
  return crowd(random, [&random] {
    const double half = dyadic(random, 1, 1, -10, 10);
    const Vec3 p = small_vector(random, 1 << 11);
    return random.one_in(2) ? at_rest(Sphere{half}, {p, {}}) : at_rest(Box{Vec3::Constant(half)}, {p, {}});
  });
}

/// Tight clusters far apart.
Scene clusters(Random& random) {
  return crowd(random, [&random] {
    const Vec3 centre = 1024 * small_vector(random, 1);
    const Vec3 p = centre + small_vector(random, 3);
    const Polytope solid = bipyramid(some_polygon(random), -1, 1);
    return at_rest(solid, {p, small_quaternion(random)});
  });
}

/// All bodies along one axis, so that two of the three sorted lists give no information.
Scene line(Random& random) {
  const int axis = random.below(3);
  return crowd(random, [&random, axis] {
    Vec3 p = Vec3::Zero();
    p[axis] = -random.whole(0, 60);
    return at_rest(Box{Vec3::Ones()}, {p, {}});
  });
}

/// Overlapping on two axes and separated on the third: a sweep along one of the two finds many false neighbours.
Scene stacked_plates(Random& random) {
  const int axis = random.below(3);
  return crowd(random, [&random, axis] {
    Vec3 half = Vec3::Constant(8);
    half[axis] = 0.125;
    Vec3 p = 0.25 * small_vector(random, 3);
    p[axis] = 0.25 * random.whole(-40, 40);
    return at_rest(Box{half}, {p, {}});
  });
}

Scene turned_solids(Random& random) {
  return crowd(random, [&random] {
    const Vec3 p = small_vector(random, 9);
    const Quaternion q = small_quaternion(random);
    switch (random.below(3)) {
      case 0:
        return at_rest(Box{Vec3{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)}}, {p, q});
      case 1:
        return at_rest(Sphere{dyadic(random, 1, 8, -2, 0)}, {p, q});
      default:
        return at_rest(summit(random, some_kind(random)), {p, q});
    }
  });
}

/// Rotated by 45° or by a Pythagorean angle, so that a face or an edge is exactly perpendicular to an axis: its
/// vertices tie as extremes.
Scene tied_extremes(Random& random) {
  return crowd(random, [&random] {
    const Vec3 half{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
    const Quaternion turn = twist(random);
    const Quaternion q = times(axes_quaternion(random), turn);
    return at_rest(block(-half, half), {5 * small_vector(random, 4), q});
  });
}

/// Every number is a random double: no two end points are equal, and every product is rounded. Balls may be far greater
/// than their distance from the origin.
Scene generic(Random& random) {
  const auto number = [&random] { return 2 * random.unit() - 1; };
  return crowd(random, [&] {
    const Pose X{Vec3{4 * number(), 4 * number(), 4 * number()}, {number(), number(), number(), number()}};
    if (random.one_in(4)) {
      const double nearer = std::ldexp(1.0, -random.between(0, 12));
      return at_rest(Sphere{random.unit() + 1}, {nearer * X.p_WB, {}});
    }
    return at_rest(Box{Vec3{random.unit() + 0x1p-9, random.unit() + 0x1p-9, random.unit() + 0x1p-9}}, X);
  });
}

}  // namespace

std::vector<Family> crowd_families() {
  const std::vector<std::string> queries = {"bounds", "broad_phase"};
  return {
      {"crowd.touching_boxes", "2 to 40 cells of a lattice: neighbours touch exactly", queries, true, touching_boxes},
      {"crowd.nearly_touching", "cells of a lattice, each side 2^-20 too short, right or too long", queries, true,
       nearly_touching_boxes},
      {"crowd.equal_ends", "boxes whose end points are all among five to seven integers", queries, true, equal_ends},
      {"crowd.identical", "the same box many times", queries, true, identical_boxes},
      {"crowd.size_ratio", "boxes and spheres that differ in size by up to 2^20", queries, true, size_ratio},
      {"crowd.clusters", "turned solids in tight clusters", queries, true, clusters},
      {"crowd.line", "boxes along one axis, at negative coordinates", queries, true, line},
      {"crowd.plates", "thin plates stacked along one axis, in part touching", queries, true, stacked_plates},
      {"crowd.turned", "boxes, spheres and polytopes at integer quaternions", queries, true, turned_solids},
      {"crowd.tied_extremes", "blocks turned so that whole edges and faces are extreme", queries, true, tied_extremes},
      {"crowd.generic", "turned boxes and balls, every number a random double", queries, false, generic},
  };
}

}  // namespace touchstone::properties
