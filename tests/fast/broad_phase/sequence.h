// Random sequences of broad-phase operations (insert, move, remove), with the true pairs.
#pragma once

#include <map>
#include <vector>

#include "fast/broad_phase/strategy.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::tests {

/// The pairs of overlapping boxes, by testing all.
inline std::vector<fast::BodyPair> true_pairs(const std::map<fast::BodyId, Aabb>& boxes) {
  std::vector<fast::BodyPair> pairs;
  for (auto a = boxes.begin(); a != boxes.end(); ++a)
    for (auto b = std::next(a); b != boxes.end(); ++b)
      if ((a->second.lo.array() <= b->second.hi.array()).all() && (b->second.lo.array() <= a->second.hi.array()).all())
        pairs.push_back({a->first, b->first});
  return pairs;
}

/// Kinds of worlds: each finds errors that the others miss.
enum class World { lattice, spread, sizes, flat, points, cluster, far };
inline constexpr World worlds[] = {World::lattice, World::spread,  World::sizes, World::flat,
                                   World::points,  World::cluster, World::far};

inline Aabb box_in(World world, Dice& dice) {
  const Vec3 p = dice.in_cube();
  switch (world) {
    case World::lattice: {  // ties everywhere
      const Vec3 lo = dice.lattice(4);
      return {lo, lo + Vec3(dice.between(0, 2), dice.between(0, 2), dice.between(0, 2))};
    }
    case World::spread:
      return {p, p + Vec3(0.3, 0.2, 0.4)};
    case World::sizes:
      return {p, p + std::exp2(dice.between(-20, 0)) * Vec3(1, 0.5, 0.7)};
    case World::flat:
      return {Vec3(p.x(), p.y(), 1e-3 * p.z()), Vec3(p.x() + 0.2, p.y() + 0.2, 1e-3 * p.z() + 0.2)};
    case World::points: {
      const Vec3 lo = dice.lattice(1);
      return {lo, lo};
    }
    case World::cluster: {
      const Vec3 lo = 1e3 * dice.lattice(1) + 0.1 * p;
      return {lo, lo + Vec3::Constant(0.05)};
    }
    case World::far: {
      const Vec3 lo = std::ldexp(1, dice.between(-900, 900)) * p;
      return {lo, lo + std::ldexp(1, dice.between(-900, 900)) * Vec3(1, 1, 1)};
    }
  }
  return {};
}

/// A small step, of the lattice's kind or of the others'.
inline Aabb stepped(World world, const Aabb& box, Dice& dice) {
  const double step = world == World::lattice || world == World::points ? 1 : 0.05;
  const Vec3 by = step * dice.lattice(1);
  return {box.lo + by, box.hi + by};
}

}  // namespace touchstone::tests
