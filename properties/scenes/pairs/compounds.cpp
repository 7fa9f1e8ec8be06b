// Compounds of unlike parts on both sides of a plane, of which one part of each touches it at the same point, or
// nearly.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

/// Above z = 0, and touching it at (0, 0, 0).
Part touching_part(Random& random, bool balls) {
  const int kind = balls ? 0 : random.below(3);
  const double size = kind == 0 ? dyadic(random, 1, 3, -20, 2) : random.whole(1, 4);
  if (kind == 0) return {{{0, 0, size}, {}}, Sphere{size}};
  if (kind == 1) return {{{0, 0, size}, {}}, Box{Vec3{1, random.whole(1, 4), size}}};
  return {{}, depression(random, some_kind(random))};
}

/// Such a compound, `gap` higher.
Compound above_the_plane(Random& random, double gap, bool balls) {
  Compound compound;
  const int count = random.between(2, 4), touches = random.below(count);
  for (int i = 0; i < count; ++i) {
    Part part = touching_part(random, balls);
    part.X_BP.p_WB.z() += gap;
    if (i != touches) {
      const Vec3 away{random.whole(-4, 4), random.whole(-4, 4), random.whole(0, 3)};
      part.X_BP.p_WB += away;
    }
    compound.parts.push_back(std::move(part));
  }
  return compound;
}

/// Half a turn about x: from above the plane to below it.
constexpr Quaternion upside_down{0, 1, 0, 0};

Scene on_a_plane(Random& random, const Pose& X, double gap, bool balls) {
  const Compound below = above_the_plane(random, 0, balls);
  return pair(random, at_rest(below, {X.p_WB, times(X.q_WB, upside_down)}),
              at_rest(above_the_plane(random, gap, balls), X));
}

Scene unlike(Random& random, bool balls) {
  const double gap = dyadic_gap(random, 1, 16);
  return on_a_plane(random, {Vec3::Zero(), small_quaternion(random)}, gap, balls);
}

/// One part of each touches the other, two further ones overlap by 1 to 2^-16, or touch too.
Scene touching_and_overlapping(Random& random) {
  const double deep = random.one_in(4) ? 0 : std::ldexp(1.0, -random.between(0, 16));
  const Vec3 aside{random.sign() * 32.0, random.whole(-4, 4), 0};
  Compound below = above_the_plane(random, 0, false), above = above_the_plane(random, 0, false);
  const auto add = [&](Compound& compound, const Vec3& p) {
    const Part part{{p, {}}, Box{Vec3{random.whole(1, 3), random.whole(1, 3), 2}}};
    const int place = random.between(0, static_cast<int>(compound.parts.size()));
    compound.parts.insert(compound.parts.begin() + place, part);
  };
  add(above, aside + Vec3(0, 0, 2 - deep));
  add(below, Vec3(aside.x(), -aside.y(), 2));  // seen upside down, it is below the other
  const Quaternion q = small_quaternion(random);
  return pair(random, at_rest(below, {Vec3::Zero(), times(q, upside_down)}), at_rest(above, {Vec3::Zero(), q}));
}

/// A ball near the origin by a part of a compound whose origin is 2^16 to 2^30 m away, turned by any angle.
Scene by_a_far_part(Random& random) {
  const auto any = [&random](double limit) { return any_vector(random, limit); };
  const Vec3 imaginary = any(1);
  const Quaternion q{0.5 + random.unit(), imaginary.x(), imaginary.y(), imaginary.z()};
  const Vec3 arm = any(std::ldexp(1.0, random.between(16, 30)));
  Compound compound{{{{arm, {}}, Box{any(0.5).cwiseAbs() + Vec3::Constant(0.25)}}, {{2 * arm, {}}, Sphere{0.125}}}};
  if (random.one_in(2)) std::swap(compound.parts[0], compound.parts[1]);
  const double radius = 0.25 + random.unit();
  const Vec3 place = any(2);
  return pair(random, at_rest(Sphere{radius}, {place, {}}), at_rest(std::move(compound), {-turned_by(q, arm), q}));
}

/// 2^40 and more from the origin; or from each other; or with a part that far away.
Scene far(Random& random) {
  const double gap = dyadic_gap(random, 1, 16);
  const int where = random.below(3);
  Vec3 p = small_vector(random, 3);
  p *= std::ldexp(1.0, random.between(40, 44));
  if (p.isZero(0)) p.x() = 0x1p40;
  const bool balls = random.one_in(3);
  Scene scene = on_a_plane(random, {where == 0 ? p : Vec3::Zero(), small_quaternion(random)}, gap, balls);
  Body& body = scene.bodies[0];
  if (where == 1) body.X_WB.p_WB = p;
  if (where == 2) std::get<Compound>(body.shape).parts.push_back({{p, {}}, Box{Vec3(1, 2, 3)}});
  return scene;
}

/// Two pairs of balls tie: one near the origin is apart by whole lengths, the other is 2^24 to 2^40 away, and apart by
/// as much but for the rounding of one of its places.
Scene tied_far_away(Random& random) {
  const Vec3 apart = random.pick<Vec3>({{1, 2, 2}, {-2, 1, 2}, {2, 3, 6}, {-6, 2, 3}, {4, 4, -7}, {3, 0, 4}});
  const double radius = random.pick({0.25, 0.5, 1.0}), other = random.pick({0.25, 0.5, 1.0});
  const Quaternion q = small_quaternion(random);
  const double far = std::ldexp(1.0, random.between(24, 36));
  const Vec3 whole{random.whole(1, 9), random.whole(-9, 9), random.whole(-9, 9)};
  const auto ball = [](const Vec3& p, double r) { return Part{{p, {}}, Sphere{r}}; };
  const Vec3 p = far * whole;
  Compound A{{ball(Vec3::Zero(), radius), ball(p, radius)}};
  Compound B{{ball({0, 0, -apart.norm()}, other), ball(turned_by(q, p) + apart, other)}};
  if (random.one_in(2)) std::swap(A.parts[0], A.parts[1]);
  if (random.one_in(2)) std::swap(B.parts[0], B.parts[1]);
  return pair(random, at_rest(std::move(A), {Vec3::Zero(), q}), at_rest(std::move(B)));
}

}  // namespace

std::vector<Family> compound_pair_families() {
  return {
      {"compounds.unlike", "two to four balls, boxes and polytopes each, that touch at one point or nearly",
       pair_queries, true, [](Random& random) { return unlike(random, false); }},
      {"compounds.balls", "balls of unlike sizes, 2^-20 to 12, that touch at one point or nearly", pair_queries, true,
       [](Random& random) { return unlike(random, true); }},
      {"compounds.touching_and_overlapping",
       "two parts touch, and two others overlap by 1 to 2^-16 or touch, in any order", pair_queries, true,
       touching_and_overlapping},
      {"compounds.far",
       "such compounds 2^40 to 2^45 from the origin or from each other, or with a part that far away",
       {"bounds", "broad_phase", "distance"},
       true,
       far},
      {"compounds.by_a_far_part",
       "a ball by a part 2^16 to 2^30 from its compound's origin, which is turned by any angle",
       {"bounds", "broad_phase", "distance"},
       false,
       by_a_far_part},
      {"compounds.tied_far_away",
       "one pair of balls near the origin, and one 2^24 to 2^40 away that is as far apart but for rounding",
       {"bounds", "broad_phase", "distance"},
       false,
       tied_far_away},
  };
}

}  // namespace touchstone::properties
