// Solids whose mass properties lose digits: far from their own origin, thin, cut, or of many parts.
#include <cmath>
#include <utility>

#include "oracle/truth/truth.h"
#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

Scene alone(Body body) {
  Scene scene;
  scene.bodies.push_back(std::move(body));
  return scene;
}

Body with_density(Random& random, Body body) {
  body.mass = Density{dyadic(random, 1, 9, -10, 10)};
  return body;
}

/// A block with its corner 7, (hi, hi, hi), cut off by a triangle: `cut` along each edge.
Polytope cut_block(const Vec3& size, const Vec3& cut) {
  Polytope solid = block(-size, size);
  const Vec3 corner = solid.vertices[7];
  solid.vertices[7] -= Vec3{cut.x(), 0, 0};
  solid.vertices.emplace_back(corner - Vec3{0, cut.y(), 0});
  solid.vertices.emplace_back(corner - Vec3{0, 0, cut.z()});
  const auto cut_towards = [](int neighbour) { return neighbour == 6 ? 7 : neighbour == 5 ? 8 : 9; };
  for (std::vector<int>& face : solid.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] != 7) continue;
      const int before = face[(i + face.size() - 1) % face.size()], after = face[(i + 1) % face.size()];
      face[i] = cut_towards(before);
      face.insert(face.begin() + static_cast<std::ptrdiff_t>(i) + 1, cut_towards(after));
      break;
    }
  }
  solid.faces.push_back({7, 8, 9});
  return solid;
}

Scene cut_cubes(Random& random) {
  const Vec3 size{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
  const double part = dyadic(random, 1, 7, -2, -2);  // of edges that are 2·size long: never the whole edge
  const Vec3 cut = part * Vec3{size.x(), random.one_in(2) ? size.y() : 0.25, size.z()};
  return alone(with_density(random, at_rest(mapped(cut_block(size, cut), some_axes(random)))));
}

/// The integrals over tetrahedra with a vertex at the origin exceed the result by (distance / size)^k.
Scene far_off_origin(Random& random, const Vec3& t) {
  const Polytope upright = bipyramid(some_polygon(random), -2, 2);
  Polytope solid = mapped(upright, some_axes(random));
  return alone(with_density(random, at_rest(shifted(std::move(solid), t))));
}

/// Corners in any pose, three of them on a lattice; the fourth is in their plane up to a few roundings. Such a solid
/// has a volume, but in doubles about no corner.
Scene lost_volumes(Random& random) {
  const auto corner = [&random]() -> Vec3 {
    const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1;
    return 8 * Vec3{x, y, 2 * random.unit() - 1};
  };
  const Vec3 a = corner(), b = corner(), c = corner();
  const double share = random.unit(), other = random.unit();
  Vec3 d = a + share * (b - a) + other * (c - a);
  d[random.below(3)] *= 1 + std::ldexp(random.between(1, 4), -52);
  return alone(with_density(random, at_rest(oracle::truth::convex_hull({a, b, c, d}))));
}

Scene slivers(Random& random) {
  const Vec3 a = Vec3::Zero(), b{random.whole(1, 9), 0, 0}, c{random.whole(-9, 9), random.whole(1, 9), 0};
  const Vec3 d{random.whole(-9, 9), random.whole(-9, 9), dyadic(random, 1, 3, -20, 0)};
  return alone(with_density(random, at_rest(tetrahedron(a, b, c, d), {Vec3::Zero(), small_quaternion(random)})));
}

Scene densities(Random& random) {
  const double radius = dyadic(random, 1, 9, -8, 8);
  Body sphere = with_density(random, at_rest(Sphere{radius}, {small_vector(random, 9), {}}));
  const Vec3 half{dyadic(random, 1, 9, -8, 8), dyadic(random, 1, 9, -8, 8), dyadic(random, 1, 9, -8, 8)};
  Body box = with_density(random, at_rest(Box{half}, {Vec3::Zero(), small_quaternion(random)}));
  return pair(random, std::move(sphere), std::move(box));
}

/// Principal moments that satisfy the triangle inequality, one of them often with equality, about the axes of the body
/// or about others.
Scene given(Random& random) {
  MassProperties mass;
  mass.mass = dyadic(random, 1, 9, -10, 10);
  mass.p_BBcm = small_vector(random, 4);
  const double x = random.whole(1, 9), y = random.whole(1, 9);
  const Vec3 moments{x, y, random.one_in(2) ? x + y : std::max(x, y)};
  mass.I_BBcm_B = moments.asDiagonal();
  if (random.one_in(2)) {
    const Mat3 thrice_a_rotation = (Mat3() << 1, -2, 2, 2, -1, -2, 2, 2, 1).finished();
    mass.I_BBcm_B = thrice_a_rotation * moments.asDiagonal() * thrice_a_rotation.transpose();
  }
  Body body = at_rest(Box{Vec3::Ones()});
  body.mass = mass;
  Body fixed = at_rest(block(Vec3::Zero(), Vec3::Ones()));
  fixed.mass = Fixed{};
  return pair(random, std::move(body), std::move(fixed));
}

Scene mirrored_compound(Random& random) {
  const double apart = random.whole(1, 9);
  const Polytope solid = pyramid(some_polygon(random), -1, 2);
  Compound compound;
  for (const double side : {-1.0, 1.0}) {
    compound.parts.push_back(
        {{Vec3{side * apart, 0, 0}, {}}, mapped(solid, Eigen::Vector3i(static_cast<int>(side), 1, 1).asDiagonal())});
  }
  if (random.one_in(2))
    compound.parts.push_back({{small_vector(random, 3), small_quaternion(random)}, Sphere{random.whole(1, 3)}});
  return alone(with_density(random, at_rest(std::move(compound))));
}

}  // namespace

std::vector<Family> mass_families() {
  const std::vector<std::string> queries = {"mass", "bounds"};
  return {
      {"mass.cut_cubes", "blocks with a corner cut off", queries, true, cut_cubes},
      {"mass.off_origin_floats", "small solids 2^4 to 2^12 from their own origin", queries, true,
       [](Random& random) {
         return far_off_origin(random, dyadic(random, 1, 1, 4, 12) * Vec3{1, -2, 3});
       }},
      {"mass.off_origin", "small solids 2^13 to 2^40 from their own origin", queries, false,
       [](Random& random) {
         return far_off_origin(random, dyadic(random, 1, 1, 13, 40) * Vec3{3, 1, -2});
       }},
      {"mass.slivers", "tetrahedra down to 2^-20 thin, turned", queries, true, slivers},
      {"mass.lost_volumes", "tetrahedra in any pose whose volume is lost in rounding", queries, false, lost_volumes},
      {"mass.densities", "spheres and boxes of sizes and densities that differ by 2^20", queries, true, densities},
      {"mass.given", "stated mass properties about any axes, some on the triangle inequality, beside a fixed body",
       queries, true, given},
      {"mass.mirrored", "compounds of two mirrored parts and perhaps a sphere", queries, true, mirrored_compound},
  };
}

}  // namespace touchstone::properties
