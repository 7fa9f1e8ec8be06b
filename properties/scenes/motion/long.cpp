// Long ways to a contact: many periods of a free rotation, or distances beside which the bodies are tiny.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/scenes/thrown.h"

namespace touchstone::properties {
namespace {

/// A flat body, or nearly, that spins almost about its axis of greatest inertia: ω returns to its start about once in a
/// turn, and errors of ω hardly grow.
Body tumbling(Random& random) {
  MassProperties given;
  given.mass = random.whole(1, 4);
  const Vec3 moments =
      random.pick<Vec3>({Vec3(1, 2, 3), Vec3(2, 3, 5), Vec3(3, 4, 7), Vec3(2, 3, 4.75), Vec3(4, 5, 8.75)});
  given.I_BBcm_B = moments.asDiagonal();
  const double sign = random.sign();
  Body body = some_box(random);
  body.mass = given;
  body.velocity.w_WB = {random.whole(-2, 2), random.whole(1, 2), sign * random.whole(15, 20)};
  return body;
}

/// Towards each other so slowly that one tumbles for 8 periods of its rotation and more before they touch.
Scene many_periods(Random& random) {
  Body A = tumbling(random), B = random.one_in(3) ? tumbling(random) : some_ball(random);
  const double seconds = random.pick({4.0, 5.0, 6.0}), speed = random.whole(4, 16);
  const Vec3 from{speed * seconds + 2 * solid_reach, random.whole(-2, 2), random.whole(-2, 2)};
  B.velocity.v_WBcm = {speed, 0, 0};
  return thrown(random, at(std::move(A), from), std::move(B), motion_until(2 * seconds + 4));
}

/// The distance is 2^4 to 2^60 times the sizes. They are fast, or have that much time.
Scene from_afar(Random& random) {
  const int k = random.between(4, 60);
  const double far = std::ldexp(1.0, k), speed = random.whole(1, 4);
  Body A = with_mass(random, some_solid(random)), B = with_mass(random, some_solid(random));
  A.X_WB.p_WB = {far, random.whole(-3, 3), random.whole(-3, 3)};
  const bool fast = random.one_in(2);
  if (fast && random.one_in(2)) A = spun(random, std::move(A));
  A.velocity.v_WBcm = {fast ? -speed * far : -speed, 0, 0};
  return thrown(random, std::move(A), std::move(B), motion_until(fast ? 2 : 2 * far));
}

}  // namespace

std::vector<Family> long_motion_families() {
  const std::vector<std::string> queries = {"time_of_impact"};
  return {
      {"flights.many_periods", "more than 8 periods of a tumbling body before it touches", queries, true, many_periods},
      {"flights.from_afar", "2^4 to 2^60 sizes apart", queries, true, from_afar},
  };
}

}  // namespace touchstone::properties
