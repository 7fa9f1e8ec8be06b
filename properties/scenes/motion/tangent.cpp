// Motions that are tangent to a contact: bodies that graze in passing, and parabolas that turn at a contact. They touch
// exactly, or overlap or miss by next to nothing. All numbers are dyadic, so it is known when they touch; a motion ends
// at twice that time.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/scenes/thrown.h"

namespace touchstone::properties {
namespace {

/// 1, or 1 ± 2^-k with k from 31 to 50.
double nearly_one(Random& random) {
  const double sign = random.pick({-1.0, 0.0, 1.0});
  return 1 + std::ldexp(sign, -random.between(31, 50));
}

/// Balls or boxes that pass each other: exactly touching, or by 2^-31 to 2^-50 of their sizes not.
Scene grazing(Random& random) {
  const Vec3 a{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
  const Vec3 b{random.whole(1, 4), random.whole(1, 4), random.whole(1, 4)};
  const bool balls = random.one_in(2);
  Body A = balls ? at_rest(Sphere{a.z()}) : at_rest(Box{a});
  Body B = balls ? at_rest(Sphere{b.z()}) : at_rest(Box{b});
  const double touch = random.pick({0.5, 1.0, 1.5, 2.0}), speed = random.whole(2, 16);
  // Boxes touch when their ends reach each other, balls when their centres do.
  A.X_WB.p_WB.x() = -speed * touch - (balls ? 0 : a.x() + b.x());
  A.X_WB.p_WB.z() = (a.z() + b.z()) * nearly_one(random);
  if (!balls)
    A.X_WB.p_WB.y() = random.one_in(3) ? a.y() + b.y() : random.whole(-1, 1);  // an edge past an edge, or faces
  const Vec3 carried = small_vector(random, 4);
  B.velocity.v_WBcm = carried;
  A.velocity.v_WBcm = carried + Vec3(speed, 0, 0);
  return thrown(random, std::move(A), std::move(B), motion_until(2 * touch));
}

/// Compounds of two balls each. One pair, large in three of four scenes, misses by 2^-45 to 2^-50 of its size: less
/// than doubles can tell. Later the other pair touches exactly, or overlaps or misses by as little; or, if it is the
/// smaller one, it overlaps by 2^-12 of its size.
Scene grazing_twice(Random& random) {
  const double first = random.pick({0.5, 1.0, 1.5}), later = first + random.pick({0.5, 1.0, 2.0});
  const double speed = random.whole(1, 8);
  Compound passing, standing;
  const auto add = [&](double time, double radius, double y, double apart) {
    passing.parts.push_back({{{0, y, radius * (1 + apart)}, {}}, Sphere{radius}});
    standing.parts.push_back({{{speed * time, y, -radius}, {}}, Sphere{radius}});
  };
  double size = dyadic(random, 1, 1, 8, 14), other = dyadic(random, 1, 1, -2, 1);
  if (random.one_in(4)) std::swap(size, other);
  const auto next_to_nothing = [&](double sign) { return std::ldexp(sign, -random.between(45, 50)); };
  add(first, size, 0, next_to_nothing(1));
  const double apart = next_to_nothing(random.pick({-1.0, 0.0, 0.0, 1.0}));
  add(later, other, 16, other < size && random.one_in(3) ? -0x1p-12 : apart);
  Body A = at_rest(std::move(passing)), B = at_rest(std::move(standing));
  MassProperties about_origin;  // so that little is rounded for the smaller pair
  about_origin.mass = 1;
  about_origin.I_BBcm_B = Mat3::Identity();
  A.mass = B.mass = about_origin;
  const Vec3 carried = small_vector(random, 4);
  B.velocity.v_WBcm = carried;
  A.velocity.v_WBcm = carried + Vec3(speed, 0, 0);
  return thrown(random, std::move(A), std::move(B), motion_until(2 * later));
}

/// A ball in an arc that passes the edge of a box within 2^-40 to 2^-50 of its radius, touching it or not, and lands on
/// the box a little later.
Scene past_an_edge(Random& random) {
  const double radius = std::ldexp(1.0, -random.between(3, 5)), g = 8, up = random.whole(3, 5),
               along = random.whole(1, 2);
  const double time = 0.25;  // of the passage, before the top
  const Vec3 there{along * time, 0, up * time - g * time * time / 2}, v{along, 0, up - g * time};
  const Vec3 below = Vec3(v.z(), 0, -v.x()).normalized();
  const double sign = random.sign();
  const Vec3 edge = there + radius * (1 + std::ldexp(sign, -random.between(40, 50))) * below;
  Body box = at_rest(Box{Vec3(1, 1, 1)}), ball = moving(at_rest(Sphere{radius}), {along, 0, up});
  box.X_WB.p_WB = edge + Vec3(1, random.whole(-1, 1) / 2, -1);
  return thrown(random, std::move(ball), fixed(std::move(box)), motion_until(2), {0, 0, -g});
}

/// m/s² downwards, by gravity or by a force: exact, and with dyadic square roots.
constexpr double fall = 8;

/// `rising` falls towards −z, relative to `other`.
Scene turning(Random& random, Body rising, Body other, const Motion& motion) {
  if (random.one_in(2)) return thrown(random, std::move(rising), fixed(std::move(other)), motion, {0, 0, -fall});
  MassProperties given;
  given.mass = random.whole(1, 4);
  given.I_BBcm_B = given.mass * Mat3::Identity();
  rising.mass = given;
  Motion forced = motion;
  forced.force_bound = given.mass * fall;
  forced.forces = {{0, 0, Vec3(0, 0, -given.mass * fall)}};
  Scene scene;
  scene.bodies = {std::move(rising), std::move(other)};
  scene.motion = std::move(forced);
  return turned_somehow(random, std::move(scene));
}

/// Thrown up at a ceiling that it reaches exactly, by 2^-31 to 2^-50 of the height too far, or by as much too little.
Scene to_a_ceiling(Random& random) {
  const double half = random.whole(1, 4), top = random.pick({0.5, 1.0, 1.5, 2.0});  // s
  Body ball = random.one_in(2) ? at_rest(Sphere{half}) : at_rest(Box{Vec3(1, 2, half)});
  Body ceiling = at_rest(Box{Vec3(16, 16, 1)});
  ceiling.X_WB.p_WB.z() = (half + 1 + fall * top * top / 2) * nearly_one(random);
  return turning(random, moving(std::move(ball), {random.whole(-2, 2), 0, fall * top}), std::move(ceiling),
                 motion_until(2 * top));
}

/// Thrown in an arc past the edge of a ledge. At the top it is 4^-m above the ledge's lower face, so its corner is
/// above that face for 2^-m / 2 before and after the top. It arrives there a multiple of 2^-m / 4 before or after the
/// top: under the ledge, exactly in its corner, or against its side.
Scene past_a_ledge(Random& random) {
  const double top = random.pick({1.0, 1.5, 2.0});
  const int m = random.between(2, 20);
  const double early = random.pick({-1.0, -0.5, -0.25, -0.25, -0.25, 0.0, 0.25, 0.5, 1.0}), along = random.whole(1, 4);
  Body box = at_rest(Box{Vec3(1, 2, 1)}), ledge = at_rest(Box{Vec3(16, 4, 1)});
  box.velocity.v_WBcm = {along, 0, fall * top};
  const double arrival = top - std::ldexp(early, -m), reach = fall * top * top / 2;
  ledge.X_WB.p_WB = {17 + along * arrival, random.whole(-2, 2), 2 + reach - std::ldexp(1.0, -2 * m)};
  return turning(random, std::move(box), std::move(ledge), motion_until(2 * top));
}

Scene turning_points(Random& random) { return random.one_in(2) ? to_a_ceiling(random) : past_a_ledge(random); }

}  // namespace

std::vector<Family> tangent_motion_families() {
  const std::vector<std::string> queries = {"time_of_impact"};
  return {
      {"flights.tangent", "balls or boxes that touch exactly in passing, or by 2^-31 to 2^-50 do not", queries, false,
       grazing},
      {"flights.grazing_twice", "a pair of balls of two compounds just misses, and later another touches, or nearly",
       queries, false, grazing_twice},
      {"flights.past_an_edge", "a ball that just passes an edge of a box, or does not, and lands on the box", queries,
       false, past_an_edge},
      {"flights.turning_points", "parabolas that turn at a contact, just before it or just after", queries, false,
       turning_points},
  };
}

}  // namespace touchstone::properties
