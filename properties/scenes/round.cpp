// Nearly round solids with exact ties, since all their corners lie on one circle or sphere of the lattice; and spheres
// themselves.
#include <cmath>
#include <utility>

#include "oracle/truth/truth.h"
#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

/// 12, 16, 24 or 36 corners.
Polygon some_circle(Random& random) {
  const int n = random.one_in(8) ? random.pick({325, 4225}) : random.pick({25, 65});
  return lattice_circle(n);
}

/// Equal prisms side by side. A lattice circle is symmetric about its centre: a shift by the sum of two neighbouring
/// corners makes two faces coincide, and a shift by twice a corner makes two edges coincide.
Scene prisms(Random& random) {
  const Polygon circle = some_circle(random);
  const auto corner = [&circle](int i) { return circle[static_cast<std::size_t>(i) % circle.size()]; };
  const int i = random.below(static_cast<int>(circle.size()));
  const Eigen::Vector2i shift = corner(i) + corner(i + random.below(2));
  const double height = random.whole(1, 40);
  const Vec3 t{shift.x() + dyadic_gap(random, 0, 8), static_cast<double>(shift.y()), random.whole(-1, 1) * height};
  const Polytope solid = prism(circle, 0, height);
  const Pose X{Vec3::Zero(), small_quaternion(random)};
  return pair(random, at_rest(solid, X), at_rest(shifted(solid, t), X));
}

/// Face on face, with B's rotated: every corner of the common circle ties with the others.
Scene stacked_prisms(Random& random) {
  const Polygon circle_below = some_circle(random);
  const Polygon circle_above = some_circle(random);
  Polytope below = prism(circle_below, -random.whole(1, 20), 0);
  Polytope above = prism(circle_above, 0, random.whole(1, 20));
  const double gap = dyadic_gap(random, 0, 12);
  const Pose X{Vec3::Zero(), small_quaternion(random)};
  const Quaternion turn = random.one_in(2) ? Quaternion{} : twist(random);
  return across(random, std::move(below), std::move(above), gap, X, {}, turn);
}

/// The hulls of all lattice points with x² + y² + z² = n.
std::vector<Polytope> lattice_spheres() {
  std::vector<Polytope> solids;
  for (const int n : {2, 5, 6, 9, 14}) {
    std::vector<Vec3> points;
    for (int x = -4; x <= 4; ++x) {
      for (int y = -4; y <= 4; ++y) {
        for (int z = -4; z <= 4; ++z) {
          if (x * x + y * y + z * z == n) points.emplace_back(x, y, z);
        }
      }
    }
    solids.push_back(oracle::truth::convex_hull(points));
  }
  return solids;
}

/// A shift of twice a corner (vertex on vertex), or of the sum of two corners of a face (edge on edge, or overlapping).
Scene lattice_sphere_pair(Random& random) {
  static const std::vector<Polytope> solids = lattice_spheres();
  const Polytope& A = random.pick(solids);
  const Polytope& B = random.one_in(2) ? A : random.pick(solids);
  const Vec3 near_A = random.pick(A.vertices);
  Vec3 t = near_A + random.pick(B.vertices);
  if (random.one_in(2)) t = near_A - random.pick(B.vertices);
  t[random.below(3)] += dyadic_gap(random, 0, 12);
  const Pose X{Vec3::Zero(), small_quaternion(random)};
  return pair(random, at_rest(A, X), at_rest(shifted(B, t), X));
}

/// Lattice vectors of integer length: {x, y, z, length}.
Eigen::Vector4d whole_vector(Random& random) {
  const Vec3 turn_signs{random.whole(0, 1), random.whole(0, 1), random.whole(0, 1)};
  const Eigen::Vector4d v = random.pick<Eigen::Vector4d>({{1, 0, 0, 1},
                                                          {3, 4, 0, 5},
                                                          {5, 12, 0, 13},
                                                          {1, 2, 2, 3},
                                                          {2, 3, 6, 7},
                                                          {1, 4, 8, 9},
                                                          {4, 4, 7, 9},
                                                          {2, 6, 9, 11}});
  const Vec3 signs = Vec3::Ones() - 2 * turn_signs;
  const int x = random.below(3);
  Eigen::Vector4d turned;
  for (int i = 0; i < 3; ++i) turned[i] = signs[i] * v[(i + x) % 3];
  turned[3] = v[3];
  return turned;
}

Scene spheres(Random& random) {
  const Eigen::Vector4d v = whole_vector(random);
  const double r = v[3] * dyadic(random, 1, 7, -3, -3);
  const double other = v[3] - r + dyadic_gap(random, 4, 16);
  const Vec3 p = small_vector(random, 16);
  return pair(random, at_rest(Sphere{r}, {p, {}}), at_rest(Sphere{other}, {p + v.head<3>(), small_quaternion(random)}));
}

/// Near the corner of a block at the origin: a coordinate > 0 is outside, < 0 is over a face, and 0 is exactly on a
/// Voronoi plane.
Scene sphere_beside_corner(Random& random) {
  const Eigen::Vector4d v = whole_vector(random);
  Vec3 c = v.head<3>().cwiseAbs();
  double distance = v[3];
  for (int i = 0; i < 3; ++i) {
    if (c[i] == 0) c[i] = -random.whole(0, 2);  // the other components still have an integer length
  }
  if (random.one_in(3)) {  // over a face: only one coordinate matters
    c = Vec3{-random.whole(0, 2), -random.whole(0, 2), distance};
  }
  const Vec3 half{random.whole(1, 3), random.whole(1, 3), random.whole(1, 3)};
  const Quaternion q = axes_quaternion(random);
  const double radius = distance + dyadic_gap(random, 2, 16);
  const Body corner = random.one_in(2) ? at_rest(block(-2 * half, Vec3::Zero()), {Vec3::Zero(), q})
                                       : at_rest(Box{half}, {turned_by_axes(q, -half), q});
  return pair(random, corner, at_rest(Sphere{radius}, {turned_by_axes(q, c), {}}));
}

Scene sphere_on_summit(Random& random) {
  Polytope below = summit(random, some_kind(random));
  const double radius = dyadic(random, 1, 8, -3, 3);
  const double gap = dyadic_gap(random, 2, 14);
  const Quaternion q = axes_quaternion(random);
  return pair(random, at_rest(std::move(below), {Vec3::Zero(), q}),
              at_rest(Sphere{radius}, {turned_by_axes(q, {0, 0, radius + gap}), {}}));
}

}  // namespace

std::vector<Family> round_families() {
  return {
      {"round.prisms", "prisms of 12 to 36 cocircular corners side by side, turned as one", convex_pair_queries, true,
       prisms},
      {"round.stacked_prisms", "such prisms on top of each other, one twisted", convex_pair_queries, true,
       stacked_prisms},
      {"round.lattice_spheres", "hulls of cospherical lattice points with big coplanar faces", convex_pair_queries,
       true, lattice_sphere_pair},
      {"spheres.lattice", "spheres whose centres are a whole length apart: touching exactly, or by 2^-4 to 2^-16 not",
       convex_pair_queries, true, spheres},
      {"spheres.beside_corner",
       "a sphere at a whole distance from a block's corner, edge or face, or on a Voronoi plane", convex_pair_queries,
       true, sphere_beside_corner},
      {"spheres.on_summit", "a sphere straight over a vertex, an edge or a face", convex_pair_queries, true,
       sphere_on_summit},
  };
}

}  // namespace touchstone::properties
