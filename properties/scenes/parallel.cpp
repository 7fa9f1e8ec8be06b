// Parallel and nearly parallel edges and faces: many closest pairs, and cross products that vanish.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

Pose turned_pose(Random& random) { return {Vec3::Zero(), small_quaternion(random)}; }

/// Two ridges along x, one above the other, shifted along x so that they share a segment, a point, or nothing.
Scene parallel_edges(Random& random) {
  Polytope below = summit(random, Kind::edge);
  const Polytope above = depression(random, Kind::edge);
  const Vec3 shift{random.whole(-9, 9), 0, 0};
  const double gap = dyadic_gap(random, 0, 12);
  const Pose X = turned_pose(random);
  return across(random, std::move(below), shifted(above, shift), gap, X);
}

Scene crossed_edges(Random& random) {
  Polytope below = summit(random, Kind::edge);
  Polytope above = depression(random, Kind::edge);
  const double gap = dyadic_gap(random, 0, 16);
  Quaternion turn = twist(random);
  if (turn.z == 0) turn.z = 1;
  const Pose X = turned_pose(random);
  return across(random, std::move(below), std::move(above), gap, X, {}, turn);
}

/// The two ridges cross at 2^-7 to 2^-21 rad.
Scene nearly_parallel_edges(Random& random) {
  Polytope below = summit(random, Kind::edge);
  Polytope above = depression(random, Kind::edge);
  const double gap = dyadic_gap(random, 0, 16);
  const Quaternion turn{std::ldexp(1.0, random.between(8, 22)), 0, 0, random.pick({-1.0, 1.0})};
  const Pose X = random.one_in(2) ? Pose{} : turned_pose(random);
  return across(random, std::move(below), std::move(above), gap, X, {}, turn);
}

/// Two faces in one plane or separated by a gap, B's shifted by lattice steps. There is no twist, so that edges are
/// often collinear too.
Scene coplanar_faces(Random& random) {
  const Polygon polygon = some_polygon(random);
  const Polygon other = random.one_in(2) ? polygon : some_polygon(random);
  Polytope below = prism(polygon, -random.whole(1, 4), 0);
  Polytope above = prism(other, 0, random.whole(1, 4));
  const Vec3 shift{random.whole(-5, 5), random.whole(-5, 5), 0};
  const double gap = dyadic_gap(random, 0, 16);
  const Pose X = turned_pose(random);
  return across(random, std::move(below), shifted(std::move(above), shift), gap, X);
}

/// A face tilted relative to the other by 2^-7 to 2^-21 rad, about an axis through a common point.
Scene nearly_parallel_faces(Random& random) {
  Polytope below = summit(random, Kind::face);
  Polytope above = depression(random, Kind::face);
  const Quaternion tilt{std::ldexp(1.0, random.between(8, 22)), random.whole(-1, 1), random.pick({-1.0, 1.0}), 0};
  const double gap = dyadic_gap(random, 0, 8);
  const Pose X = random.one_in(2) ? Pose{} : turned_pose(random);
  return across(random, std::move(below), std::move(above), gap, X, {}, tilt);
}

/// Two boxes in a generic rotation, that of one an ulp or a few off, whose faces are apart by next to nothing: whether
/// and where they touch is decided by the last bits.
Scene within_ulps(Random& random) {
  const auto any = [&random] { return 3 * random.unit() - 1.5; };
  Quaternion q{any(), any(), any(), any()};
  const Vec3 a{random.whole(1, 2), 1, random.whole(1, 2)}, b{1, random.whole(1, 2), random.whole(1, 2)};
  Body A = at_rest(Box{a}, {Vec3::Zero(), q});
  const int axis = random.below(3);
  Vec3 offset{0.25 * random.whole(-4, 4), 0.25 * random.whole(-4, 4), 0.25 * random.whole(-4, 4)};
  offset[axis] = (a[axis] + b[axis]) * random.sign();
  const Vec3 p = turned_by(q, offset);
  for (double* component : {&q.w, &q.x, &q.y, &q.z}) {
    for (int ulps = random.below(3); ulps > 0; --ulps) *component = std::nextafter(*component, 4 * random.sign());
  }
  Scene scene;
  scene.bodies = {std::move(A), at_rest(Box{b}, {p, q})};
  return scene;
}

/// Boxes as polytopes in a common rotated frame: their faces are exactly parallel, but rounded rotations do not show
/// it.
Scene same_quaternion(Random& random) {
  const auto size = [&random] { return random.whole(1, 5); };
  const Vec3 A_lo = small_vector(random, 3);
  const Vec3 A_hi = A_lo + Vec3{size(), size(), size()};
  Vec3 B_lo = small_vector(random, 3);
  const int axis = random.below(3);
  B_lo[axis] = A_hi[axis] + dyadic_gap(random, 1, 18);
  const Vec3 B_size{size(), size(), size()};
  const Pose X = turned_pose(random);
  return pair(random, at_rest(block(A_lo, A_hi), X), at_rest(block(B_lo, B_lo + B_size), X));
}

/// A cube whose faces are divided into four triangles each, around a vertex in the middle: valid, but hard for normals.
Polytope unmerged_block(double half) {
  Polytope solid = block(Vec3::Constant(-half), Vec3::Constant(half));
  std::vector<std::vector<int>> triangles;
  for (const std::vector<int>& face : solid.faces) {
    const int centre = static_cast<int>(solid.vertices.size());
    Vec3 middle = Vec3::Zero();
    for (const int i : face) middle += solid.vertices[static_cast<std::size_t>(i)] / 4;
    solid.vertices.push_back(middle);
    for (std::size_t i = 0; i < 4; ++i) triangles.push_back({face[i], face[(i + 1) % 4], centre});
  }
  solid.faces = std::move(triangles);
  return solid;
}

Scene unmerged_faces(Random& random) {
  const double half = random.whole(1, 4);
  const double height = random.whole(1, 4);
  Polytope below = shifted(unmerged_block(height), {0, 0, -height});
  const Vec3 shift{random.whole(-3, 3), random.whole(-3, 3), 0};
  Polytope above =
      random.one_in(2) ? shifted(unmerged_block(half), {0, 0, half}) : depression(random, some_kind(random));
  const double gap = dyadic_gap(random, 0, 12);
  const Pose X = turned_pose(random);
  return across(random, std::move(below), shifted(std::move(above), shift), gap, X);
}

}  // namespace

std::vector<Family> parallel_families() {
  return {
      {"parallel.edges", "parallel edges above each other, sharing a segment, a point or nothing", convex_pair_queries,
       true, parallel_edges},
      {"parallel.crossed_edges", "edges that cross at a rational angle", convex_pair_queries, true, crossed_edges},
      {"parallel.nearly_edges", "edges that cross at 2^-7 to 2^-21 rad", convex_pair_queries, true,
       nearly_parallel_edges},
      {"parallel.coplanar_faces", "faces in one plane or parallel, shifted along it by lattice steps",
       convex_pair_queries, true, coplanar_faces},
      {"parallel.nearly_faces", "faces tilted against each other by 2^-7 to 2^-21 rad", convex_pair_queries, true,
       nearly_parallel_faces},
      {"parallel.within_ulps", "boxes in rotations that differ by ulps, within ulps of touching", convex_pair_queries,
       false, within_ulps},
      {"parallel.same_quaternion", "boxes that one rational rotation turns: their faces are exactly parallel",
       convex_pair_queries, true, same_quaternion},
      {"parallel.unmerged_faces", "faces cut into coplanar triangles, with vertices in their middles",
       convex_pair_queries, true, unmerged_faces},
  };
}

}  // namespace touchstone::properties
