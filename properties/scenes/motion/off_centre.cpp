// Motions in which a body's origin is not its centre of mass, in which its rotation grows, or in which the force that
// acts on it has replaced another.
#include <cmath>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/scenes/thrown.h"

namespace touchstone::properties {
namespace {

/// With equal moments about a centre of mass up to 6 from its origin, and spinning: the origin goes round it.
Body eccentric(Random& random, Body body) {
  MassProperties given;
  given.mass = random.whole(1, 4);
  given.I_BBcm_B = 16 * given.mass * Mat3::Identity();
  const double factor = random.pick({0.25, 1.0, 2.0});
  given.p_BBcm = factor * small_vector(random, 3);
  body.mass = given;
  body.velocity.w_WB = small_vector(random, 3);
  return body;
}

/// A ball, a solid or two balls.
Body some_shape(Random& random) {
  if (random.one_in(2)) return some_ball(random);
  if (random.one_in(2)) return some_solid(random);
  const Vec3 p = small_vector(random, 3);
  return at_rest(Compound{{{{p, {}}, Sphere{random.whole(1, 3)}}, {{-p, {}}, Sphere{random.whole(1, 3)}}}});
}

/// They approach, or stay beside each other.
Scene off_centre(Random& random) {
  Body A = eccentric(random, some_shape(random));
  Body B = random.one_in(2) ? eccentric(random, some_shape(random)) : with_mass(random, some_solid(random));
  const double away = 2 * solid_reach + random.whole(1, 6);
  const Vec3 from{away, random.whole(-6, 6), random.whole(-6, 6)};
  A.velocity.v_WBcm = {-random.whole(0, 8), 0, 0};
  return thrown(random, at(std::move(A), from), std::move(B), motion_until(2));
}

/// A rod that spins nearly about its middle axis, which is unstable: it turns over, faster about its length, and its
/// ends sweep what they did not reach before.
Scene turning_over(Random& random) {
  MassProperties given;
  given.mass = random.whole(1, 4);
  const Vec3 moments = random.pick<Vec3>({Vec3(2, 3, 4), Vec3(4, 5, 6), Vec3(3, 4, 6)});
  given.I_BBcm_B = given.mass * moments.asDiagonal();
  Body A = at_rest(Box{Vec3{random.whole(1, 2), random.whole(1, 2), random.whole(4, 8)}});
  A.mass = given;
  const double astray = dyadic(random, 1, 3, -4, -1), sign = random.sign();
  A.velocity.w_WB = {astray, sign * random.whole(2, 4), random.one_in(2) ? astray : 0};
  Body B = at_rest(Sphere{random.whole(1, 2)});
  if (random.one_in(2)) B.shape = Box{Vec3{1, 1, random.whole(1, 2)}};
  Vec3 from{random.whole(-2, 2), random.whole(-2, 2), random.whole(-2, 2)};
  const double side = random.sign(), away = side * random.whole(8, 10);
  from[random.below(2)] = away;
  B.velocity.v_WBcm = 0.25 * small_vector(random, 1);
  return thrown(random, std::move(A), at(std::move(B), from), motion_until(3));
}

/// It turns by about half a turn while it comes down on a wide plate; often nearly about its long axis, so that its
/// ends hardly move at first.
Scene onto_a_plate(Random& random, Body body, const Vec3& axis) {
  Vec3 w = 0.5 * small_vector(random, 3);
  if (random.one_in(2)) {
    const Vec3 astray = 0.125 * small_vector(random, 2);
    const double sign = random.sign(), speed = random.pick({1.5, 2.0});
    w = sign * speed * axis + astray;
  }
  if (w.isZero(0)) w.x() = 1;
  if (random.one_in(2)) body.X_WB.q_WB = small_quaternion(random);
  const Vec3 v{random.whole(-1, 1), random.whole(-1, 1), -0.5 * random.whole(3, 5)};
  Body plate = at_rest(Box{Vec3(32, 32, 1)});
  if (random.one_in(2)) plate.mass = Fixed{};
  const Vec3 from{0, 0, 1 + random.whole(5, 7)};
  return thrown(random, moving(at(std::move(body), from), v, w), std::move(plate), motion_until(4));
}

MassProperties some_mass(Random& random, const Mat3& moments) {
  MassProperties given;
  given.mass = random.whole(1, 4);
  given.I_BBcm_B = given.mass * moments;
  return given;
}

Mat3 some_tilted_moments(Random& random) {
  Mat3 a, b, c;
  a << 3, 1, 0, 1, 3, 0, 0, 0, 3;  // 2, 4 and 3
  b << 5, 1, 0, 1, 4, 1, 0, 1, 6;
  c << 4, 1, 0, 1, 5, -1, 0, -1, 6;
  return random.pick<Mat3>({a, b, c});
}

/// A rod whose principal axes of inertia are not its own.
Scene tilted_inertia(Random& random) {
  Body rod = at_rest(Box{Vec3{random.whole(3, 4), random.pick({0.125, 0.25, 1.0}), 0.125}});
  const Mat3 moments = some_tilted_moments(random);
  rod.mass = some_mass(random, moments);
  return onto_a_plate(random, std::move(rod), Vec3::UnitX());
}

/// Two small bodies at the ends of a massless arm: they reach far from the centre of mass. With a density, one moment
/// is far smaller than the others.
Scene dumbbells(Random& random) {
  Compound compound;
  const double arm = random.whole(2, 4), half = random.pick({0.125, 0.25, 0.5});
  const Vec3 along = random.pick<Vec3>({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}), end = arm * along;
  for (const double side : {-1.0, 1.0}) {
    ConvexShape shape = Sphere{half};
    if (random.one_in(2)) shape = Box{Vec3{half, 0.5 * half, half}};
    compound.parts.push_back({{side * end, random.one_in(2) ? Quaternion{} : small_quaternion(random)}, shape});
  }
  Body dumbbell = at_rest(std::move(compound));
  const Mat3 moments = random.one_in(2) ? some_tilted_moments(random) : Mat3(Vec3(3, 4, 5).asDiagonal());
  const MassProperties given = some_mass(random, moments);
  if (random.one_in(2)) {
    dumbbell.mass = Density{random.pick({0.5, 1.0, 3.0})};
  } else {
    dumbbell.mass = given;
  }
  return onto_a_plate(random, std::move(dumbbell), along);
}

/// A polytope of three equal moments, which are sums that round: it rotates steadily, but about no axis of its own.
Scene equal_moments(Random& random) {
  const double half = random.pick({1.0, 2.0});
  const Vec3 x(half, 0, 0), y(0, half, 0), z(0, 0, half), corner = x + y + z;
  Polytope solid;
  switch (random.below(3)) {
    case 0:
      solid = block(-corner, corner);
      break;
    case 1:
      solid = tetrahedron(corner, x - y - z, y - z - x, z - x - y);
      break;
    default:
      solid = bipyramid({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, -1, 1);
      for (Vec3& v : solid.vertices) v *= half;
  }
  Body body = at_rest(std::move(solid));
  body.mass = Density{random.pick({0.5, 1.0, 3.0})};
  if (random.one_in(2)) body.X_WB.q_WB = small_quaternion(random);
  Vec3 w = small_vector(random, 3);
  if (w.isZero(0)) w.x() = 1;
  const Vec3 v{random.whole(-1, 1), random.whole(-1, 1), -random.whole(2, 5)};
  Body other = at_rest(Box{Vec3(32, 32, 1)});
  if (random.one_in(2)) other = with_mass(random, some_solid(random));
  const Vec3 from{0, 0, solid_reach + 4 + random.whole(0, 2)};
  return thrown(random, moving(at(std::move(body), from), v, w), std::move(other), motion_until(4));
}

/// A body starts after forces on it, of which the last counts.
Scene pushed_before(Random& random) {
  Body A = with_mass(random, some_solid(random)), B = with_mass(random, some_solid(random));
  const Vec3 v{-random.whole(4, 12), 0, 0}, from{2 * solid_reach + random.whole(1, 8), random.whole(-2, 2), 0};
  Scene scene;
  scene.bodies = {moving(at(std::move(A), from), v), std::move(B)};
  const double start = random.pick({0.25, 0.5});
  scene.motion = motion_until(4);
  scene.motion->start_times = {start, random.one_in(2) ? start : 0};
  scene.motion->force_bound = 64;
  const Vec3 first = small_vector(random, 16), second = small_vector(random, 16), last = small_vector(random, 16);
  scene.motion->forces = {{0, 0, first}, {start / 2, 0, second}};
  if (random.one_in(2)) scene.motion->forces.push_back({start, 0, last});
  return turned_somehow(random, std::move(scene));
}

}  // namespace

std::vector<Family> off_centre_motion_families() {
  const std::vector<std::string> queries = {"time_of_impact"};
  return {
      {"flights.off_centre", "balls and solids that spin about a centre of mass away from their origin", queries, true,
       off_centre},
      {"flights.turning_over", "rods that spin about their unstable axis and turn over", queries, true, turning_over},
      {"flights.pushed_before", "several forces before a body starts, of which the last counts", queries, true,
       pushed_before},
      {"flights.tilted_inertia", "rods whose principal axes are not their own come down on a plate", queries, true,
       tilted_inertia},
      {"flights.equal_moments", "polytopes of three equal moments and a density fly at others, turning", queries, true,
       equal_moments},
      {"flights.dumbbells", "two small bodies on an arm, half of them of a density, come down on a plate, turning",
       queries, true, dumbbells},
  };
}

}  // namespace touchstone::properties
