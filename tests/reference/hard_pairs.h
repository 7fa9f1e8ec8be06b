// Pairs of bodies that are near-degenerate on purpose: small lattices, equal orientations, tiny and zero gaps, ties.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "model/scene.h"
#include "reference/convex_hull.h"

namespace touchstone::tests {

/// splitmix64 (Steele, Lea, Flood 2014): the same numbers everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  int between(int low, int high) { return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1)); }
  double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
  double around_zero() { return 2 * unit() - 1; }
  Vec3 lattice(int reach) { return cell(-reach, reach); }
  Vec3 cell(int low, int high) {
    const int x = between(low, high);
    const int y = between(low, high);
    return Vec3(x, y, between(low, high));
  }
  Vec3 in_cube() {
    const double x = around_zero();
    const double y = around_zero();
    return {x, y, around_zero()};
  }

 private:
  std::uint64_t state_;
};

inline Body body(Shape shape, const Vec3& p_WB = Vec3::Zero(), const Quaternion& q_WB = {}) {
  Body b;
  b.shape = std::move(shape);
  b.X_WB = {p_WB, q_WB};
  return b;
}

inline Scene pair(Body A, Body B) {
  Scene scene;
  scene.bodies = {std::move(A), std::move(B)};
  return scene;
}

/// Between braces C++ evaluates from left to right, between parentheses in any order: draws that share an expression
/// stand in braces, so that every compiler makes the same scenes.
struct PlacedBody {
  Shape shape;
  Vec3 p_WB = Vec3::Zero();
  Quaternion q_WB = {};
};

inline Scene pair_of(const std::vector<PlacedBody>& both) {
  return pair(body(both[0].shape, both[0].p_WB, both[0].q_WB), body(both[1].shape, both[1].p_WB, both[1].q_WB));
}

inline Quaternion integer_quaternion(Dice& dice) {
  Quaternion q;
  do {
    q = {double(dice.between(-3, 3)), double(dice.between(-3, 3)), double(dice.between(-3, 3)),
         double(dice.between(-3, 3))};
  } while (q == Quaternion{0, 0, 0, 0});
  return q;
}

/// n random points of the ball's surface, to rounding: a simplicial hull.
inline Polytope round_hull(Dice& dice, int n) {
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < n) {
    const Vec3 p = dice.in_cube();
    if (p.norm() > 0.1 && p.norm() < 1) points.push_back(p.normalized());
  }
  return reference::convex_hull(points);
}

/// Small integer coordinates; a box when the points drawn have no volume.
inline Shape lattice_hull(Dice& dice, int points, int reach) {
  std::vector<Vec3> drawn;
  for (int i = 0; i < points; ++i) drawn.push_back(dice.lattice(reach));
  try {
    return reference::convex_hull(drawn);
  } catch (const std::exception&) {
    return Box{dice.cell(1, reach)};
  }
}

/// x² + y² = square exactly, at z = ±height: a prism with cocircular ends.
inline Polytope lattice_prism(int square, double height) {
  std::vector<Vec3> points;
  const int reach = static_cast<int>(std::sqrt(square));
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      if (x * x + y * y != square) continue;
      points.emplace_back(x, y, height);
      points.emplace_back(x, y, -height);
    }
  }
  return reference::convex_hull(points);
}

/// x² + y² + z² = square exactly: cospherical, with large plane faces.
inline Polytope lattice_sphere(int square) {
  std::vector<Vec3> points;
  const int reach = static_cast<int>(std::sqrt(square));
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        if (x * x + y * y + z * z == square) points.emplace_back(x, y, z);
      }
    }
  }
  return reference::convex_hull(points);
}

inline Polytope stretched(Polytope p, const Vec3& factors) {
  for (Vec3& v : p.vertices) v = v.cwiseProduct(factors);
  return p;
}

inline double tiny_gap(Dice& dice) {
  const int sign = dice.between(-1, 1);
  return sign * std::ldexp(1.0, -dice.between(1, 52));
}

inline void scale(Scene& scene, int exponent) {
  const double s = std::ldexp(1.0, exponent);
  for (Body& b : scene.bodies) {
    b.X_WB.p_WB *= s;
    if (auto* box = std::get_if<Box>(&b.shape)) box->half_extents *= s;
    if (auto* sphere = std::get_if<Sphere>(&b.shape)) sphere->radius *= s;
    if (auto* polytope = std::get_if<Polytope>(&b.shape)) *polytope = stretched(*polytope, Vec3(s, s, s));
  }
}

inline constexpr int hard_families = 14;

/// A completed pair of family `family` in [0, hard_families).
inline Scene hard_pair(int family, Dice& dice) {
  static const std::vector<Polytope> prisms = {lattice_prism(25, 3), lattice_prism(325, 8), lattice_prism(4225, 20)};
  static const std::vector<Polytope> spheres = {lattice_sphere(9), lattice_sphere(14), lattice_sphere(29)};
  const Quaternion q = integer_quaternion(dice);
  switch (family) {
    case 0:  // lattice hulls, upright
      return pair_of({{lattice_hull(dice, 8, 3), dice.lattice(4)}, {lattice_hull(dice, 8, 3), dice.lattice(4)}});
    case 1:  // lattice hulls, turned
      return pair_of({{lattice_hull(dice, 6, 2), dice.lattice(4), q},
                      {lattice_hull(dice, 12, 3), dice.lattice(4), integer_quaternion(dice)}});
    case 2:  // lattice hulls, turned alike
      return pair_of(
          {{lattice_hull(dice, 10, 2), dice.lattice(3), q}, {lattice_hull(dice, 10, 2), dice.lattice(3), q}});
    case 3: {  // boxes a tiny gap apart, face to face
      const double gap = tiny_gap(dice);
      const int y = dice.between(-3, 3);
      return pair_of({{Box{Vec3(1, 2, 3)}}, {Box{Vec3(1, 1, 1)}, Vec3(2 + gap, y, dice.between(-4, 4))}});
    }
    case 4: {  // a vertex above a face
      Polytope needle = reference::convex_hull({Vec3(0, 0, 0), Vec3(1, 0, 4), Vec3(-1, 1, 4), Vec3(-1, -1, 4)});
      const double x = dice.around_zero();
      return pair_of({{needle, Vec3(x, 0, 1 + tiny_gap(dice))}, {Box{Vec3(2, 2, 1)}}});
    }
    case 5: {  // edges crossed
      Polytope roof = reference::convex_hull({Vec3(-2, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 3), Vec3(0, -1, 3)});
      Polytope keel = reference::convex_hull({Vec3(0, -2, 0), Vec3(0, 2, 0), Vec3(1, 0, -3), Vec3(-1, 0, -3)});
      const Vec3 above = dice.lattice(1);
      return pair_of({{roof, Vec3(above.x(), above.y(), tiny_gap(dice))}, {keel}});
    }
    case 6: {  // prisms with cocircular ends
      const Polytope& prism = prisms[static_cast<std::size_t>(dice.between(0, 2))];
      const double r = prism.vertices[0].norm();
      const double z = dice.between(-1, 1) * r;
      return pair_of({{prism, r * dice.in_cube(), q}, {prism, Vec3(0, 0, z), dice.between(0, 1) ? q : Quaternion{}}});
    }
    case 7:  // cospherical hulls
      return pair_of({{spheres[static_cast<std::size_t>(dice.between(0, 2))], dice.lattice(8)},
                      {spheres[static_cast<std::size_t>(dice.between(0, 2))], Vec3::Zero(),
                       dice.between(0, 1) ? q : Quaternion{}}});
    case 8: {  // needles and plates
      const double thin = std::ldexp(1.0, -dice.between(10, 20));
      return pair_of({{stretched(round_hull(dice, 12), Vec3(1, thin, thin)), 0.5 * dice.in_cube(), q},
                      {stretched(round_hull(dice, 12), Vec3(1, 1, thin)), 0.5 * dice.in_cube()}});
    }
    case 9: {  // coincident, nested, concentric
      const Shape shape = lattice_hull(dice, 12, 3);
      const int kind = dice.between(0, 2);
      if (kind == 0) return pair(body(shape, Vec3(1, 2, 3), q), body(shape, Vec3(1, 2, 3), q));
      if (kind == 1) return pair(body(spheres[0], Vec3(0, 0, 0), q), body(spheres[2]));
      return pair(body(Sphere{0.5}), body(shape));
    }
    case 10: {  // other scales
      Scene scene = hard_pair(dice.between(0, 5), dice);
      const int exponents[] = {-500, -60, -40, 40, 60, 500};
      scale(scene, exponents[dice.between(0, 5)]);
      return scene;
    }
    case 11: {  // far from the origin, and of very different sizes
      Scene scene = hard_pair(dice.between(0, 5), dice);
      const int exponent = dice.between(20, 45);
      const Vec3 far = std::ldexp(1.0, exponent) * dice.lattice(3);
      for (Body& b : scene.bodies) b.X_WB.p_WB += far;
      return scene;
    }
    case 12: {  // spheres and compounds
      Compound compound;
      for (int i = 0; i < 3; ++i) {
        ConvexShape part = Sphere{double(dice.between(1, 2))};
        if (i > 0) part = Box{dice.cell(1, 2)};
        compound.parts.push_back({Pose{dice.lattice(3), integer_quaternion(dice)}, part});
      }
      return pair_of({{compound, dice.lattice(4), q}, {Sphere{double(dice.between(1, 3))}, dice.lattice(5)}});
    }
    default:  // quaternions far from unit length
      const Quaternion huge = {q.w * 1e150, q.x * 1e150, q.y * 1e150, q.z * 1e150};
      const Quaternion tiny = {q.w * 1e-160, q.x * 1e-160, q.y * 1e-160, q.z * 1e-160};
      return pair_of(
          {{lattice_hull(dice, 8, 2), dice.lattice(3), huge}, {lattice_hull(dice, 8, 2), dice.lattice(3), tiny}});
  }
}

}  // namespace touchstone::tests
