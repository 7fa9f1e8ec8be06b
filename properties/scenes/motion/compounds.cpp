// Motions of compounds of unlike parts, and of bodies of which one appears where the other has just arrived.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/scenes/thrown.h"

namespace touchstone::properties {
namespace {

ConvexShape some_part(Random& random) {
  switch (random.below(3)) {
    case 0:
      return Sphere{random.whole(1, 2)};
    case 1:
      return Box{Vec3{random.whole(1, 2), random.whole(1, 2), random.whole(1, 2)}};
    default:
      return pyramid(some_polygon(random), -1, 1);
  }
}

/// Two or three parts that may overlap, all within 9 of the body's origin.
Body some_compound(Random& random) {
  Compound compound;
  for (int i = random.between(2, 3); i > 0; --i) {
    const Vec3 p = small_vector(random, 2);
    const Quaternion q = random.one_in(2) ? Quaternion{} : small_quaternion(random);
    compound.parts.push_back({{p, q}, some_part(random)});
  }
  return at_rest(std::move(compound));
}

/// With equal moments where it turns.
Body maybe_spun(Random& random, Body body) {
  if (random.one_in(3)) return body;
  body = spun(random, std::move(body));
  if (std::holds_alternative<Density>(body.mass)) body.velocity.w_WB.setZero();
  return body;
}

/// At a slant, turning; one or both are compounds.
Scene compounds(Random& random) {
  Body A = maybe_spun(random, some_compound(random));
  Body B = random.one_in(3) ? some_compound(random) : with_mass(random, some_solid(random));
  B = maybe_spun(random, std::move(B));
  const Vec3 from{2 * solid_reach + random.whole(4, 8), random.whole(-3, 3), random.whole(-3, 3)};
  A.velocity.v_WBcm = {-random.whole(8, 16), random.whole(-2, 2), random.whole(-2, 2)};
  const Vec3 gravity{0, 0, random.one_in(2) ? -8.0 : 0.0};
  return thrown(random, at(std::move(A), from), std::move(B), motion_until(3), gravity);
}

/// One starts 1/4 to 4 s after the other, which is then next to it (0 or 2^-4 to 2^-40 apart) and approaches, or parts.
Scene late_starts(Random& random) {
  const Vec3 a{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
  const Vec3 b{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
  const bool balls = random.one_in(3);
  Body first = balls ? at_rest(Sphere{a.x()}) : at_rest(Box{a}),
       late = balls ? at_rest(Sphere{b.x()}) : at_rest(Box{b});
  if (balls) first = spun(random, std::move(first));
  const double gap = std::abs(dyadic_gap(random, 4, 40)), start = random.pick({0.25, 0.5, 1.0, 2.0, 4.0});
  const double sign = random.sign(), along = sign * random.whole(1, 8), g = random.pick({0.0, 0.0, 8.0});
  first.velocity.v_WBcm = {along, 0, g * start / 2};  // back at its height when the other starts
  late.X_WB.p_WB = {along * start + a.x() + b.x() + gap, 0, 0};
  if (!balls) late.X_WB.p_WB.y() = random.whole(-1, 1);
  Motion motion = motion_until(start + 1);
  motion.start_times = {0, start};
  return thrown(random, std::move(first), std::move(late), motion, {0, 0, -g});
}

}  // namespace

std::vector<Family> compound_motion_families() {
  const std::vector<std::string> queries = {"time_of_impact"};
  return {
      {"flights.compounds", "a compound of unlike parts against another or a solid", queries, true, compounds},
      {"flights.late_starts", "one starts where the other has just arrived, or has been", queries, false, late_starts},
  };
}

}  // namespace touchstone::properties
