// Motions of two bodies that come into contact or narrowly miss: head-on, oblique, grazing, thin and fast, rotating,
// thrown up, in contact from the start. Each is drawn in simple axes, and then the whole scene is rotated.
#include "properties/transforms/motion.h"

#include <cmath>
#include <utility>

#include "model/box_vertices.h"
#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/scenes/thrown.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

Vec3 some_gravity(Random& random) { return random.one_in(2) ? Vec3(0, 0, 0) : Vec3(0, 0, -8); }

Body maybe_spun(Random& random, Body body) { return random.one_in(2) ? body : spun(random, std::move(body)); }

/// Towards each other along x, slightly offset.
Scene head_on(Random& random) {
  Body A = with_mass(random, some_solid(random)), B = with_mass(random, some_solid(random));
  const Vec3 off{0, random.whole(-2, 2), random.whole(-2, 2)};
  const Vec3 v{random.whole(1, 16), 0, 0}, w{random.whole(-16, 0), 0, 0};
  const double away = 2 * solid_reach + random.whole(1, 8);
  return thrown(random, moving(at(std::move(A), off), v), moving(at(std::move(B), {away, 0, 0}), w),
                motion_until(random.pick({1.0, 2.0, 4.0})));
}

/// From any position, rotating.
Scene oblique(Random& random) {
  Body A = maybe_spun(random, with_mass(random, some_solid(random)));
  Body B = maybe_spun(random, with_mass(random, some_solid(random)));
  const Vec3 from{2 * solid_reach + random.whole(1, 8), random.whole(-8, 8), random.whole(-8, 8)};
  const Vec3 v = small_vector(random, 3), towards{-random.whole(8, 16), 0, 0};
  A.X_WB.p_WB = from;
  A.velocity.v_WBcm = v + towards;
  B.velocity.v_WBcm = v;
  return thrown(random, std::move(A), std::move(B), motion_until(2), some_gravity(random));
}

/// Balls or boxes that pass within 2^-4 to 2^-40 of touching, with a gap or an overlap.
Scene grazing(Random& random) {
  const bool balls = random.one_in(2);
  const double a = random.whole(1, 4), b = random.whole(1, 4);
  Body A = at_rest(Box{Vec3(1, 1, a)}), B = at_rest(Box{Vec3(2, 1, b)});
  if (balls) A.shape = Sphere{a}, B.shape = Sphere{b};
  const int sign = random.sign();
  const double past = a + b + std::ldexp(sign, -random.between(4, 40));
  const Vec3 from{-16, balls ? 0 : random.whole(-1, 1), past};
  return thrown(random, moving(at(std::move(A), from), {random.whole(4, 16), 0, 0}), std::move(B), motion_until(4));
}

/// The same for summits and depressions of any kind: they slide past each other along the plane between them.
Scene sliding_past(Random& random) {
  const Quaternion q = axes_quaternion(random);
  const double gap = std::ldexp(1, -random.between(4, 12));
  Scene scene = contact(random, gap, {Vec3::Zero(), q});
  const double speed = random.whole(8, 32);
  const Vec3 along = turned_by_axes(q, random.one_in(2) ? Vec3(speed, 0, 0) : Vec3(0, -speed, 0));
  scene.bodies[0].X_WB.p_WB -= along;  // the position of closest approach, after 1 s
  scene.bodies[0].velocity.v_WBcm = along;
  scene.motion = motion_until(2);
  return scene;
}

/// Rods of 16:1 to 128:1 that rotate end over end.
Scene needles(Random& random) {
  const auto needle = [&random] {
    const double half = random.whole(8, 16), thick = std::ldexp(1, -random.between(0, 3));
    Body body = at_rest(Box{Vec3(half, thick, thick)});
    body.velocity.w_WB = {0, random.whole(-4, 4), random.whole(1, 6)};
    return body;
  };
  Body A = needle(), B = needle();
  const Vec3 from{random.whole(-8, 8), 34, random.whole(-8, 8)};
  A.X_WB.p_WB = from;
  A.velocity.v_WBcm = {0, -random.whole(8, 24), 0};
  return thrown(random, std::move(A), std::move(B), motion_until(2), some_gravity(random));
}

/// A thin rod that spins about its length while its axis turns, until an end of it comes down.
Scene javelins(Random& random) {
  const double half = random.whole(4, 16), thick = half * std::ldexp(1, -random.between(4, 7));
  Body rod = at_rest(Box{Vec3(half, thick, thick)});
  const double spin = random.sign() * random.whole(16, 64), turn = random.sign() * random.whole(1, 5);
  rod.velocity.w_WB = {spin, turn, random.whole(-1, 1)};
  const double below = half * random.whole(6, 14) / 16;
  Body other = fixed(at_rest(Box{Vec3(4 * half, 4 * half, 1)}, {{0, 0, -below - 1}, {}}));
  if (random.one_in(3)) {
    const Vec3 ahead(half * (turn > 0 ? 0.75 : -0.75), 0, -below - 1);
    other = fixed(at_rest(Sphere{1}, {ahead, {}}));
  }
  return thrown(random, std::move(rod), std::move(other), motion_until(1));
}

/// Plates that a body crosses within a step of 1/60 s.
Scene thin_plates(Random& random) {
  const double thin = std::ldexp(1, -random.between(4, 12)), speed = random.whole(64, 1024);
  const Vec3 half{thin, random.whole(2, 8), random.whole(2, 8)};
  Body plate = at_rest(Box{half});
  Body shot = random.one_in(2) ? some_ball(random) : at_rest(Box{half});
  const Vec3 from{16 + random.whole(0, 32), random.whole(-2, 2), random.whole(-2, 2)};
  if (random.one_in(2)) plate = fixed(std::move(plate));
  return thrown(random, moving(at(std::move(shot), from), {-speed, 0, 0}), std::move(plate), motion_until(1));
}

/// In contact at the start: approaching, separating, or separating for a while.
Scene touching(Random& random) {
  const Quaternion q = axes_quaternion(random);
  Scene scene = contact(random, 0, {Vec3::Zero(), q});
  const int sign = random.sign();
  const double speed = sign * random.whole(1, 8);
  const Vec3 v = turned_by_axes(q, {random.whole(-2, 2), random.whole(-2, 2), speed});
  scene.bodies[0].velocity.v_WBcm = v;
  if (random.one_in(3)) {  // thrown off a fixed body, and falling back
    scene.bodies[1].mass = Fixed{};
    scene.gravity = 4 * turned_by_axes(q, {0, 0, speed > 0 ? -1.0 : 1.0});
  }
  scene.motion = motion_until(2);
  return scene;
}

/// Rotating bodies with three different moments of inertia, or two equal ones.
Scene tops(Random& random) {
  const auto top = [&random] {
    MassProperties given;
    given.mass = random.whole(1, 4);
    const Vec3 moments = random.pick<Vec3>({Vec3(2, 3, 4), Vec3(4, 2, 3), Vec3(2, 2, 3), Vec3(4, 4, 1), Vec3(5, 6, 2)});
    given.I_BBcm_B = moments.asDiagonal();
    Body body = some_box(random);
    body.mass = given;
    body.velocity.w_WB = 0.25 * small_vector(random, 3);
    return body;
  };
  Body A = top(), B = random.one_in(2) ? top() : some_ball(random);
  const Vec3 from{16, random.whole(-3, 3), random.whole(-3, 3)};
  A.X_WB.p_WB = from;
  A.velocity.v_WBcm = {-32, 0, 0};
  return thrown(random, std::move(A), std::move(B), motion_until(0.5));
}

/// Thrown up at a ceiling that it barely reaches or barely misses: v²/2g = h ± 2^-4 … 2^-30.
Scene apex(Random& random) {
  const double half = random.whole(1, 4), v = random.whole(1, 4) * 8, g = 8;
  const int sign = random.sign();
  const double room = v * v / (2 * g) + std::ldexp(sign, -random.between(4, 30));
  Body ceiling = fixed(at_rest(Box{Vec3(16, 16, 1)}));
  Body ball = random.one_in(2) ? at_rest(Sphere{half}) : at_rest(Box{Vec3(1, 2, half)});
  ceiling.X_WB.p_WB = {0, 0, half + room + 1};
  return thrown(random, moving(std::move(ball), {random.whole(-2, 2), 0, v}), std::move(ceiling), motion_until(16),
                {0, 0, -g});
}

/// Each body starts at its own time.
Scene starts(Random& random) {
  Scene scene = random.one_in(2) ? head_on(random) : oblique(random);
  const double first = dyadic(random, 0, 8, -6, -4), second = dyadic(random, 0, 8, -6, -4);
  scene.motion->start_times = {first, second};
  return scene;
}

/// Solids with vertices that are no corners, in any order.
Scene redundant(Random& random) {
  Scene scene = random.one_in(2) ? head_on(random) : oblique(random);
  for (Body& body : scene.bodies) {
    if (const auto* box = std::get_if<Box>(&body.shape)) body.shape = as_polytope(*box);
    if (auto* polytope = std::get_if<Polytope>(&body.shape))
      body.shape = with_redundant_vertices(random, std::move(*polytope));
  }
  return scene;
}

/// Fixed bodies that move and rotate about their origins.
Scene turntables(Random& random) {
  const Vec3 half{16, random.whole(1, 4), random.whole(1, 2)};
  Body table = fixed(at_rest(Box{half}));
  table.velocity = {small_vector(random, 2), {0, random.whole(-1, 1), random.whole(-3, 3)}};
  Body other = maybe_spun(random, with_mass(random, some_solid(random)));
  other.velocity.v_WBcm = {random.whole(-4, 4), random.whole(-4, 4), -random.whole(4, 16)};
  other.X_WB.p_WB = {random.whole(-8, 8), random.whole(-8, 8), 32};
  return thrown(random, std::move(table), std::move(other), motion_until(3), some_gravity(random));
}

/// A force acts on one body from the start.
Scene pushed(Random& random) {
  Scene scene = random.one_in(2) ? head_on(random) : oblique(random);
  const Vec3 force = small_vector(random, 16);
  scene.motion->force_bound = 32;
  scene.motion->forces = {{0, random.below(2), force}};
  return scene;
}

Scene some_motion(Random& random) {
  switch (random.below(5)) {
    case 0:
      return head_on(random);
    case 1:
      return oblique(random);
    case 2:
      return grazing(random);
    case 3:
      return thin_plates(random);
    default:
      return apex(random);
  }
}

/// Lengths times 2^±20, times multiplied by 2^±10.
Scene times_powers(Random& random) {
  Scene scene = some_motion(random);
  scene = scaled(scene, random.between(-20, 20)).value_or(scene);
  return hastened(scene, random.between(-10, 10)).value_or(scene);
}

/// Numbers with full mantissas.
Scene generic(Random& random) {
  const auto any = [&random](double limit) -> Vec3 {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    return limit * Vec3(2 * x - 1, 2 * y - 1, 2 * z - 1);
  };
  const auto solid = [&] {
    const Vec3 half = any(1);
    Body body = random.one_in(3) ? at_rest(Sphere{half.cwiseAbs().maxCoeff() + 0.1})
                                 : at_rest(Box{half.cwiseAbs() + Vec3::Constant(0.1)});
    const Vec3 axis = any(1);
    const double angle = random.unit();
    body.X_WB.q_WB = {angle + 0.1, axis.x(), axis.y(), axis.z()};
    body = spun(random, std::move(body));
    const Vec3 spin = any(0.125);
    body.velocity.w_WB += spin;
    return body;
  };
  Body A = solid(), B = solid();
  const Vec3 v = any(1), w = any(1), off = any(1), gravity = any(9.81);
  A.velocity.v_WBcm = v;
  B.X_WB.p_WB = off + Vec3(5, 0, 0);
  B.velocity.v_WBcm = w - Vec3(4, 0, 0);
  Scene scene;
  scene.bodies = {std::move(A), std::move(B)};
  scene.gravity = gravity;
  scene.motion = motion_until(1.5 + random.unit());
  return scene;
}

}  // namespace

std::vector<Family> motion_families() {
  const std::vector<std::string> queries = {"time_of_impact"};
  return {
      {"flights.head_on", "at each other along an axis", queries, true, head_on},
      {"flights.oblique", "at a slant, turning", queries, true, oblique},
      {"flights.grazing", "balls or boxes that touch by 2^-4 to 2^-40, or do not", queries, false, grazing},
      {"flights.redundant", "solids with vertices on edges and in faces, in any order", queries, true, redundant},
      {"flights.sliding_past", "polytopes that pass each other by 2^-4 to 2^-12", queries, true, sliding_past},
      {"flights.needles", "slender rods that turn end over end", queries, true, needles},
      {"flights.javelins", "rods that spin about their length, and turn until an end comes down", queries, true,
       javelins},
      {"flights.thin_plates", "plates that a step would leap over", queries, true, thin_plates},
      {"flights.touching", "in contact at the start, approaching or parting", queries, true, touching},
      {"flights.tops", "bodies whose moments differ, turning", queries, true, tops},
      {"flights.apex", "thrown up, and just reaching a ceiling or not", queries, false, apex},
      {"flights.starts", "each from a time of its own", queries, true, starts},
      {"flights.turntables", "fixed bodies that move and turn", queries, true, turntables},
      {"flights.pushed", "a force acts on one", queries, true, pushed},
      {"flights.times_powers", "lengths and times by powers of two", queries, false, times_powers},
      {"flights.generic", "numbers with all their bits", queries, false, generic},
  };
}

}  // namespace touchstone::properties
