// Runs of two to six bodies: a few impacts each, before chaos and before anything piles up; and bodies that never
// touch, that rest, or that bounce for ever less. Also of some dozens, with many impacts within a thirtieth of a
// second.
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/box_vertices.h"
#include "model/limits.h"
#include "oracle/truth/truth.h"
#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/scenes/thrown.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

Scene run(Random& random, std::vector<Body> bodies, Motion motion, const Vec3& gravity = Vec3::Zero()) {
  Scene scene;
  scene.bodies = std::move(bodies);
  scene.gravity = gravity;
  motion.law = random.pick({Law::poisson, Law::poisson, Law::stronge, Law::newton});
  scene.motion = std::move(motion);
  return scene;
}

/// The n-th place of a lattice with room for one solid at each.
Vec3 place(int n) {
  constexpr double step = 2 * solid_reach + 1;
  return step * Vec3(n % 2, (n / 2) % 2, n / 4);
}

/// Bodies at places of the lattice, all moving towards its middle.
std::vector<Body> converging(Random& random, int count, bool balls) {
  std::vector<Body> bodies;
  for (int n = 0; n < count; ++n) {
    Body body = balls ? some_ball(random) : some_solid(random);
    body = with_mass(random, std::move(body));
    body.material = some_material(random);
    body.X_WB.p_WB = place(n);
    const Vec3 middle = place(3) / 2, off = small_vector(random, 1);
    body.velocity.v_WBcm = (middle - place(n)) + off;
    if (random.one_in(2)) body = spun(random, std::move(body));
    bodies.push_back(std::move(body));
  }
  return bodies;
}

Scene balls(Random& random) { return run(random, converging(random, random.between(2, 5), true), motion_until(2, 4)); }

Scene solids(Random& random) { return run(random, converging(random, 2, false), motion_until(1, 2)); }

Scene elastic_balls(Random& random) {
  std::vector<Body> bodies = converging(random, random.between(3, 6), true);
  for (Body& body : bodies) body.material = {1, 0};
  return run(random, std::move(bodies), motion_until(2, 4));
}

Body floor_at_0() { return fixed(at_rest(Box{Vec3(64, 64, 2)}, {{0, 0, -2}, {}})); }

/// Thrown onto a table, until shortly after the impact.
Scene on_a_table(Random& random) {
  std::vector<Body> bodies = {floor_at_0()};
  bodies[0].material = {1, 1};
  const int count = random.between(1, 2);
  for (int n = 0; n < count; ++n) {
    Body body = with_mass(random, some_solid(random));
    body.material = some_material(random);
    body.X_WB.p_WB = {n * 17.0, 0, 9};
    body.velocity.v_WBcm = {random.whole(-4, 4), random.whole(-4, 4), -random.whole(4, 16)};
    if (random.one_in(2)) body = spun(random, std::move(body));
    bodies.push_back(std::move(body));
  }
  return run(random, std::move(bodies), motion_until(0.75, 2), {0, 0, -8});
}

/// Equal balls in a row with gaps between them; the first, or the first and the last, move in.
Scene cradle(Random& random) {
  const int count = random.between(3, 5);
  const double gap = std::ldexp(1, -random.between(1, 6));
  std::vector<Body> bodies;
  for (int n = 0; n < count; ++n) {
    Body ball = at_rest(Sphere{1});
    ball.material = {1, 0};
    ball.X_WB.p_WB = {n * (2 + gap), 0, 0};
    bodies.push_back(std::move(ball));
  }
  bodies.front().X_WB.p_WB.x() -= 2;
  bodies.front().velocity.v_WBcm = {4, 0, 0};
  if (random.one_in(2)) {
    bodies.back().X_WB.p_WB.x() += 2;
    bodies.back().velocity.v_WBcm = {-4, 0, 0};
  }
  return run(random, std::move(bodies), motion_until(4, 4));
}

/// Several pairs with the same time of impact.
Scene ties(Random& random) {
  std::vector<Body> bodies;
  const int pairs = random.between(2, 3);
  for (int n = 0; n < pairs; ++n) {
    for (const double side : {-1.0, 1.0}) {
      Body ball = at_rest(Sphere{1});
      ball.material = some_material(random);
      ball.X_WB.p_WB = {side * 4, n * 8.0, 0};
      ball.velocity.v_WBcm = {-side * 2, 0, 0};
      bodies.push_back(std::move(ball));
    }
  }
  return run(random, std::move(bodies), motion_until(3, 2));
}

/// Ten to thirty pairs of balls that collide along any axis, not always centrally, within 2^-5 s.
Scene crowd(Random& random) {
  std::vector<Body> bodies;
  const int pairs = random.between(10, 30);
  for (int n = 0; n < pairs; ++n) {
    const Vec3 middle = 8 * Vec3(n % 2, (n / 2) % 4, n / 8);
    const double impact = 0.5 + std::ldexp(random.below(16), -9);
    const int axis = random.below(3);
    const Vec3 along = Vec3::Unit(axis), across = Vec3::Unit((axis + 1) % 3);
    for (const double side : {-1.0, 1.0}) {
      Body ball = at_rest(Sphere{1});
      ball.material = some_material(random);
      const double beside = random.whole(-2, 2) / 8;
      ball.X_WB.p_WB = middle + side * (1 + impact) * along + beside * across;
      ball.velocity.v_WBcm = -side * along;
      bodies.push_back(std::move(ball));
    }
  }
  return run(random, std::move(bodies), motion_until(1, 4));
}

/// Two balls, or a ball and a floor, elastic and without friction: one impact.
Scene one_impact(Random& random) {
  Body ball = some_ball(random);
  Body other = random.one_in(2) ? floor_at_0() : some_ball(random);
  const bool is_floor = std::holds_alternative<Fixed>(other.mass);
  ball.material = other.material = {1, 0};
  ball.X_WB.p_WB = {is_floor ? 0 : random.whole(-1, 1), 0, 16};
  ball.velocity.v_WBcm = {random.whole(-1, 1), random.whole(-1, 1), -random.whole(8, 16)};
  return run(random, {std::move(ball), std::move(other)}, motion_until(2, 2));
}

/// Two solids, or one ball whose moments are not those of a uniform one.
Scene tops(Random& random) {
  std::vector<Body> bodies = converging(random, 2, false);
  if (random.one_in(3)) {
    bodies.resize(1);
    bodies[0].shape = Sphere{random.whole(1, 4)};
  }
  for (Body& body : bodies) {
    MassProperties given;
    given.mass = random.whole(1, 4);
    given.I_BBcm_B = unlike_moments(random);
    body.mass = given;
    body.velocity.w_WB = 0.125 * small_vector(random, 3);
  }
  return run(random, std::move(bodies), motion_until(1, 2));
}

/// Forces that begin and change during the motion; or one that acts from the start (which is no event), one at the end,
/// and one after the end (which has no effect).
Scene pushed(Random& random) {
  Scene scene = run(random, converging(random, random.between(2, 3), true), motion_until(2, 4));
  scene.motion->force_bound = 64;
  std::vector<double> times = {0.25, 0.5, 1};
  if (random.one_in(4)) times = {0, 1, 2, 4};
  for (const double time : times) {
    const int body = random.below(static_cast<int>(scene.bodies.size()));
    scene.motion->forces.push_back({time, body, small_vector(random, 16)});
  }
  return scene;
}

/// Bodies that move apart.
Scene apart(Random& random) {
  std::vector<Body> bodies;
  const int count = random.between(1, 3);
  for (int n = 0; n < count; ++n) {
    Body body = with_mass(random, some_solid(random));
    body.X_WB.p_WB = place(n);
    body.velocity.v_WBcm = place(n) / 4;
    body = spun(random, std::move(body));
    bodies.push_back(std::move(body));
  }
  return run(random, std::move(bodies), motion_until(1, 4), {0, 0, -8});
}

/// Balls and blocks at rest on a level table, or above it within the envelope.
Scene at_rest_on_a_table(Random& random) {
  std::vector<Body> bodies = {floor_at_0()};
  bodies[0].material = some_material(random);
  const bool falls = !random.one_in(3);
  const int count = random.between(1, 3);
  for (int n = 0; n < count; ++n) {
    Body body = with_mass(random, random.one_in(2) ? some_ball(random) : some_box(random));
    const auto* box = std::get_if<Box>(&body.shape);
    const double half = box != nullptr ? box->half_extents.z() : std::get<Sphere>(body.shape).radius;
    body.material = some_material(random);
    if (random.one_in(2)) body.material.restitution = 0;
    body.X_WB.p_WB = {n * 17.0, 0, half + (falls ? 0 : 0x1p-12)};
    bodies.push_back(std::move(body));
  }
  Motion motion = motion_until(4, 4);
  motion.envelope = 0x1p-11;
  return run(random, std::move(bodies), std::move(motion), {0, 0, falls ? -8.0 : 0.0});
}

/// Two balls over a table within the envelope, in elastic bounces that samples hardly show: one slides, the other
/// stays.
Scene skims(Random& random) {
  std::vector<Body> bodies = {floor_at_0()};
  bodies[0].material = {1, 1};
  for (int n = 0; n < 2; ++n) {
    Body ball = at_rest(Sphere{1});
    ball.material = {1, random.pick({0.25, 0.5})};
    ball.X_WB.p_WB = {n * 17.0, 0, 1 + 0x1p-12};
    bodies.push_back(std::move(ball));
  }
  bodies[1].velocity.v_WBcm = {random.whole(1, 4), 0, 0};
  Motion motion = motion_until(0.125, 2);
  motion.envelope = 0x1p-11;
  return run(random, std::move(bodies), std::move(motion), {0, 0, -8});
}

/// A ball on a table that spins about the vertical while friction turns it about a horizontal axis. It bounces within
/// the envelope, so that all subjects may answer: those that know no resting contact too.
Scene spins(Random& random) {
  Body table = floor_at_0(), ball = at_rest(Sphere{1});
  table.material = {1, 1};
  ball.material = {1, random.pick({0.25, 0.5})};
  ball.X_WB.p_WB = {0, 0, 1 + 0x1p-18};
  ball.velocity.v_WBcm = {random.whole(2, 4), random.whole(-2, 2), 0};
  const double side = random.sign();
  ball.velocity.w_WB = {0, 0, side * random.whole(40, 72)};
  Motion motion = motion_until(0.0625, 2);
  motion.envelope = 0x1p-17;
  return run(random, {std::move(table), std::move(ball)}, std::move(motion), {0, 0, -8});
}

/// A ball above a table: for e < 1 the last sample comes after infinitely many impacts.
Scene bouncing(Random& random) {
  Body ball = some_ball(random);
  const double e = random.pick({0.0, 0.25, 0.5, 0.75, 1.0}), radius = std::get<Sphere>(ball.shape).radius;
  ball.material.restitution = e;
  Body table = floor_at_0();
  table.material.restitution = 1;
  ball.X_WB.p_WB = {0, 0, radius + random.whole(0, 4) + 0.5};
  ball.velocity.v_WBcm = {0, 0, random.whole(-2, 2)};
  return run(random, {std::move(table), std::move(ball)}, motion_until(8, 16), {0, 0, -8});
}

/// The same for a box that falls flat, which touches at four corners at once.
Scene falls_flat(Random& random) {
  Body box = with_mass(random, some_box(random));
  box.X_WB = {};
  const double e = random.pick({0.0, 0.25, 0.5, 0.75, 1.0});
  box.material = {e, random.pick({0.0, 0.5})};
  Body table = floor_at_0();
  table.material = {1, 1};
  box.X_WB.p_WB = {random.whole(-4, 4), 0, std::get<Box>(box.shape).half_extents.z() + random.whole(0, 4) + 0.5};
  box.velocity.v_WBcm = {0, 0, random.whole(-2, 2)};
  return run(random, {std::move(table), std::move(box)}, motion_until(8, 16), {0, 0, -8});
}

Body of_mass(Body body, double mass) {
  const double m = mass * size(body.shape) * size(body.shape);
  body.mass = MassProperties{mass, Vec3::Zero(), Mat3(0.5 * m * Mat3::Identity())};
  return body;
}

Body ball_at(const Vec3& p, const Vec3& v, double radius = 1) {
  Body ball = at_rest(Sphere{radius});
  ball.X_WB.p_WB = p;
  ball.velocity.v_WBcm = v;
  return ball;
}

/// Bodies that touch in a row, hit from one side or from both.
std::vector<Body> row(Random& random) {
  const int count = random.between(2, 4);
  std::vector<Body> bodies = {ball_at({-3, 0, 0}, {2, 0, 0})};
  for (int n = 0; n < count; ++n) bodies.push_back(ball_at({2.0 * n, 0, 0}, Vec3::Zero()));
  if (random.one_in(2)) bodies.push_back(ball_at({2.0 * count + 1, 0, 0}, {-2, 0, 0}));
  return bodies;
}

/// Two or three balls that are hardly apart in a row, hit from both sides at one time by balls of other masses.
std::vector<Body> nearly_touching(Random& random) {
  const int count = random.between(2, 3);
  const double pitch = 2 + std::ldexp(1.0, -random.between(33, 44)), last = (count - 1) * pitch;
  std::vector<Body> bodies = {of_mass(ball_at({-3, 0, 0}, {2, 0, 0}), random.whole(1, 3))};
  for (int n = 0; n < count; ++n) bodies.push_back(of_mass(ball_at({n * pitch, 0, 0}, Vec3::Zero()), 1));
  bodies.push_back(of_mass(ball_at({last + 3, 0, 0}, {-2, 0, 0}), random.whole(1, 3)));
  return bodies;
}

/// A ball that hits two at once: normals (4/5, ±3/5).
std::vector<Body> symmetric_break(Random& random) {
  const double speed = random.whole(1, 4);
  return {ball_at({-5, 0, 0}, {5 * speed, 0, 0}, 2.5), ball_at({4, 3, 0}, Vec3::Zero(), 2.5),
          ball_at({4, -3, 0}, Vec3::Zero(), 2.5)};
}

/// A ball that falls into a wedge of two fixed boxes with normals (±4/5, 0, 3/5).
std::vector<Body> wedge(Random& random) {
  std::vector<Body> bodies = {ball_at({0, 0, 5}, {0, 0, -4}, 1)};
  for (const double side : {1.0, -1.0}) {
    Body plane = fixed(at_rest(Box{Vec3(5, 5, 5)}));
    plane.X_WB = {{-side * 4, 0, -3}, {2, 0, side, 0}};  // its top touches the origin
    bodies.push_back(std::move(plane));
  }
  if (random.one_in(2)) std::swap(bodies[0], bodies[1]);
  return bodies;
}

/// A box that falls flat on two pillars, or is pressed by two balls at once from the sides.
std::vector<Body> pillars(Random& random) {
  std::vector<Body> bodies;
  Body beam = at_rest(Box{Vec3(4, 1, 0.5)});
  beam.X_WB.p_WB = {0, 0, 1};
  beam.velocity.v_WBcm = {random.one_in(2) ? 0 : random.whole(-1, 1), 0, -2};
  bodies.push_back(std::move(beam));
  const double inner = random.whole(0, 1), outer = random.whole(2, 3);
  for (const double side : {1.0, -1.0}) {
    Body pillar = fixed(at_rest(Box{Vec3((outer - inner) / 2, 2, 1)}));
    pillar.X_WB.p_WB = {side * (outer + inner) / 2, 0, -1};
    bodies.push_back(std::move(pillar));
  }
  return bodies;
}

/// A cube of listed vertices in a random order, that lands flat or slides when it lands.
std::vector<Body> polytope_lands(Random& random) {
  Body cube = some_box(random);
  const Box box = std::get<Box>(cube.shape);
  std::vector<Vec3> vertices = as_polytope(box).vertices;
  for (std::size_t k = vertices.size() - 1; k > 0; --k) {
    std::swap(vertices[k], vertices[random.index(k + 1)]);
  }
  cube.shape = oracle::truth::convex_hull(vertices);
  cube.X_WB = {{0, 0, box.half_extents.z() + 1}, {}};
  cube.velocity.v_WBcm = {random.whole(-1, 1), 0, -2};
  return {floor_at_0(), std::move(cube)};
}

/// A plate on posts, or a bar between balls, that lands flat on the floor. With a post more on one side, its mass is
/// not over their middle. The parts are in a random order.
std::vector<Body> lands_on_parts(Random& random) {
  const bool on_balls = random.one_in(2);
  const double out = random.whole(1, 3), across = on_balls ? 0 : random.whole(0, 2);
  const auto post = [&](double x, double y) {
    return on_balls ? Part{{{x, y, 0.5}, {}}, Sphere{0.5}} : Part{{{x, y, 1}, {}}, Box{Vec3(0.25, 0.25, 1)}};
  };
  std::vector<Part> parts;
  for (const double x : {-out, out}) {
    parts.push_back(post(x, -across));
    if (across > 0) parts.push_back(post(x, across));
  }
  if (random.one_in(3)) parts.push_back(post(out + 1, 0));
  if (random.one_in(2)) parts.push_back({{{0, 0, 2}, {}}, Box{Vec3(out, across + 0.25, 0.25)}});
  for (std::size_t k = parts.size() - 1; k > 0; --k) std::swap(parts[k], parts[random.index(k + 1)]);
  Body body = at_rest(Compound{std::move(parts)});
  body.X_WB.p_WB = {0, 0, 1};
  body.velocity.v_WBcm = {random.one_in(2) ? 0 : random.whole(-1, 1), 0, -2};
  return {floor_at_0(), std::move(body)};
}

/// A bar on two or three blocks or balls that stands on the floor, sinks and turns: some parts hit, others may
/// separate. The parts are listed along the bar, or in the reverse order.
std::vector<Body> turns_on_parts(Random& random) {
  const bool on_balls = random.one_in(2);
  std::vector<double> places{-1, 1};
  if (random.one_in(3)) places.push_back(random.pick({0.0, 2.0}));
  if (random.one_in(2)) std::ranges::reverse(places);
  std::vector<Part> parts;
  for (const double x : places) {
    parts.push_back({{{x, 0, 0}, {}}, on_balls ? ConvexShape{Sphere{0.25}} : ConvexShape{Box{Vec3(0.25, 0.25, 0.25)}}});
  }
  Body body = at_rest(Compound{std::move(parts)});
  body.X_WB.p_WB = {0, 0, 0.25};
  const double I = random.pick({0.0625, 0.25, 1.0});
  body.mass = MassProperties{1, {random.pick({0.0, 0.0, 0.5}), 0, 0}, I * Mat3::Identity()};
  body.velocity = {{0, 0, -1}, {0, random.pick({-3.0, -0.75, 0.5, 2.0, 8.0}), 0}};
  return {floor_at_0(), std::move(body)};
}

using Bodies = std::vector<Body> (*)(Random&);

/// Bodies of equal material or of unlike restitution, and samples shortly after the impacts.
Scene at_one_time(Random& random, Bodies kind) {
  std::vector<Body> bodies = kind(random);
  const double e = random.pick({0.0, 0.5, 1.0}), mu = random.pick({0.0, 0.0, 0.5}), mass = random.pick({1.0, 4.0});
  const bool is_unlike = random.one_in(2);
  for (Body& body : bodies) {
    body.material = {is_unlike ? random.pick({0.0, 0.5, 1.0}) : e, mu};
    if (std::holds_alternative<Density>(body.mass)) body = of_mass(std::move(body), mass);
  }
  return run(random, std::move(bodies), motion_until(1.25, 5));
}

Scene together(Random& random) { return at_one_time(random, random.pick<Bodies>({symmetric_break, wedge, pillars})); }

Scene parts_land(Random& random) { return at_one_time(random, lands_on_parts); }

Scene parts_separate(Random& random) {
  Scene scene = at_one_time(random, turns_on_parts);
  for (Body& body : scene.bodies) body.material.friction = 0;  // with it the law leaves the outcome open
  scene.motion->sample_times = {0x1p-10, 0x1p-5, 0.25};
  return scene;
}

Scene hardly_apart(Random& random) { return at_one_time(random, nearly_touching); }

Scene touching(Random& random) { return at_one_time(random, random.pick<Bodies>({row, polytope_lands})); }

/// Boxes and balls that slide on the table into each other.
std::vector<Body> sliders(Random& random) {
  std::vector<Body> bodies;
  const int count = random.between(2, 3);
  for (int n = 0; n < count; ++n) {
    Body body = with_mass(random, random.one_in(3) ? some_ball(random) : some_box(random));
    body.X_WB = {};
    const auto* box = std::get_if<Box>(&body.shape);
    const double half = box != nullptr ? box->half_extents.z() : std::get<Sphere>(body.shape).radius;
    if (box != nullptr && random.one_in(2)) body.X_WB.q_WB = {random.whole(1, 3), 0, 0, random.whole(-2, 2)};
    body.X_WB.p_WB = {17.0 * n, random.whole(-1, 1), half};
    body.velocity.v_WBcm = {n == 0 ? random.whole(4, 8) : -random.whole(0, 4), 0, 0};
    bodies.push_back(std::move(body));
  }
  return bodies;
}

/// A box or a ball that slides over a longer box, and drags it along.
std::vector<Body> on_another(Random& random) {
  Body carrier = with_mass(random, at_rest(Box{Vec3(8, 4, 0.5)}));
  carrier.X_WB.p_WB = {0, 0, 0.5};
  const bool is_ball = random.one_in(3);
  Body body = is_ball ? at_rest(Sphere{1}) : at_rest(Box{Vec3(1, random.pick({0.5, 1.0}), 0.5)});
  body = with_mass(random, std::move(body));
  body.X_WB.p_WB = {random.whole(-2, 2), random.whole(-2, 2), is_ball ? 2.0 : 1.5};
  body.velocity.v_WBcm = {random.whole(-3, 3), random.whole(-1, 1), 0};
  return {std::move(carrier), std::move(body)};
}

/// A box with three different sides, in any pose, that falls and spins; another one lies where it may fall on it.
std::vector<Body> dropped(Random& random) {
  Body box = with_mass(random, at_rest(Box{Vec3(random.whole(1, 2), 3, 0.5)}));
  box.X_WB = {{0, 0, 6}, small_quaternion(random)};
  box.velocity = {{random.whole(-2, 2), random.whole(-2, 2), -random.whole(0, 4)}, small_vector(random, 1)};
  std::vector<Body> bodies = {std::move(box)};
  if (random.one_in(2)) {
    Body under = with_mass(random, at_rest(Box{Vec3(1, 2, 0.5)}));
    under.X_WB.p_WB = {random.whole(-2, 2), random.whole(-2, 2), 0.5};
    bodies.push_back(std::move(under));
  }
  return bodies;
}

/// Gives all bodies one material.
void set_material(Random& random, std::vector<Body>& bodies) {
  const double e = random.pick({0.0, 0.0, 0.5}), mu = random.pick({0.25, 0.5});
  for (Body& body : bodies) body.material = {e, mu};
}

/// The bodies on a large table with this friction.
Scene on_large_table(Random& random, std::vector<Body> bodies, double friction, Motion motion) {
  bodies.push_back(large_table({1, friction}));
  Scene scene = run(random, std::move(bodies), std::move(motion), {0, 0, -8});
  scene.motion->law = Law::poisson;
  return scene;
}

/// A box with these half sides, whose middle is over (x, 0) and whose bottom is at a height; its mass is drawn.
Body block(Random& random, const Vec3& half, double x, double bottom) {
  Body box = with_mass(random, at_rest(Box{half}));
  box.X_WB.p_WB = {x, 0, bottom + half.z()};
  return box;
}

/// A beam across two boxes that move apart or together.
std::vector<Body> bridge(Random& random) {
  std::vector<Body> bodies;
  for (const double side : {-1.0, 1.0}) {
    Body pier = block(random, {0.5, 1, random.pick({0.5, 0.75})}, 2 * side, 0);
    pier.velocity.v_WBcm = {random.whole(-2, 2), random.whole(-1, 1), 0};
    bodies.push_back(std::move(pier));
  }
  bodies.push_back(block(random, {3, 0.5, 0.25}, random.whole(-2, 2) / 4, 1.5));
  return bodies;
}

/// A ball that falls between two boxes or balls, and drives them apart.
std::vector<Body> ball_between(Random& random) {
  std::vector<Body> bodies;
  for (const double side : {-1.0, 1.0}) {
    Body beside = random.one_in(2) ? with_mass(random, at_rest(Sphere{1})) : block(random, {1, 1, 1}, 0, 0);
    beside.X_WB.p_WB = {side * random.pick({1.25, 1.5}), random.whole(-1, 1) / 4, 1};
    bodies.push_back(std::move(beside));
  }
  Body ball = with_mass(random, at_rest(Sphere{1}));
  ball.X_WB.p_WB = {0, 0, 3.25};
  ball.velocity = {{0, 0, -random.whole(0, 2)}, small_vector(random, 1)};
  bodies.push_back(std::move(ball));
  return bodies;
}

/// Three bodies that rest on each other, rub, tip and fall, on a table without friction or with some.
Scene piles(Random& random) {
  std::vector<Body> bodies = random.pick<Bodies>({bridge, ball_between})(random);
  set_material(random, bodies);
  const double friction = random.pick({0.0, 0.0, 0.5});
  return on_large_table(random, std::move(bodies), friction, motion_until(0.5, 2));
}

/// A body that slides over a longer box which moves: a fixed one, or one on a table without friction that it drags
/// along. All that moves does so along one line through the middle of the box.
Scene on_a_carrier(Random& random) {
  const Vec3 line = random.pick<Vec3>({Vec3::UnitX(), Vec3::UnitY(), Vec3(1, 1, 0), Vec3(2, -1, 0)});
  const bool is_ball = random.one_in(3), on_ice = !random.one_in(3);
  const double mu = random.pick({0.25, 0.5}), e = on_ice || !is_ball ? 0 : random.pick({0.0, 0.5});
  Body carrier = with_mass(random, at_rest(Box{Vec3(8, 6, 0.5)}));
  carrier.X_WB = {{0, 0, 0.5}, {random.whole(2, 3), 0, 0, random.whole(-1, 1)}};
  carrier.velocity.v_WBcm = random.whole(-2, 2) * line;
  Body upper = is_ball ? at_rest(Sphere{1}) : at_rest(Box{Vec3(1, random.pick({0.75, 1.5}), 0.5)});
  upper = with_mass(random, std::move(upper));
  const double along = 0.5 * random.whole(-2, 2), speed = random.whole(-3, 3);
  upper.X_WB.p_WB = along * line + Vec3(0, 0, is_ball ? 2.0 : 1.5);
  if (!is_ball) upper.X_WB.q_WB = {random.whole(1, 3), 0, 0, random.whole(-1, 1)};
  upper.velocity.v_WBcm = carrier.velocity.v_WBcm + speed * line;
  if (is_ball) upper.velocity.w_WB = random.whole(-2, 2) * Vec3(-line.y(), line.x(), 0);
  carrier.material = upper.material = {e, mu};
  std::vector<Body> bodies = {std::move(upper)};
  if (on_ice) {
    bodies.push_back(large_table({0, 0}));
    bodies.push_back(std::move(carrier));
  } else {
    bodies.push_back(fixed(std::move(carrier)));
  }
  if (random.one_in(2)) std::ranges::reverse(bodies);
  return run(random, std::move(bodies), motion_until(1, 8), {0, 0, -8});
}

/// A box falls beside the middle of another one, which stands on ice: they rock, and come to rest.
Scene onto_a_box(Random& random) {
  const double half = random.whole(1, 4) / 4, height = random.whole(1, 4) / 4;
  Body lower = with_mass(random, at_rest(Box{Vec3::Ones()}, {{0, 0, 1}, {}}));
  Body upper = with_mass(random, at_rest(Box{Vec3::Constant(half)}));
  const double x = random.whole(-7, 7) / 8, y = random.whole(-7, 7) / 8;
  upper.X_WB.p_WB = Vec3(x, y, 2 + half + height);
  Body table = fixed(at_rest(Box{Vec3(64, 64, 1)}, {{0, 0, -1}, {}}));
  std::vector<Body> bodies = {std::move(table), std::move(lower), std::move(upper)};
  for (Body& body : bodies) body.material = {0, 0};
  if (random.one_in(2)) std::ranges::reverse(bodies);
  return run(random, std::move(bodies), motion_until(1, 8), {0, 0, -8});
}

/// A free box that a force on a ball or another box presses on, until it ends: they bounce, stay together and part.
Scene pressed_together(Random& random) {
  const bool is_ball = random.one_in(2);
  Body below = with_mass(random, at_rest(Box{Vec3(1, 1, random.pick({0.5, 1.0}))}));
  Body above = with_mass(random, is_ball ? at_rest(Sphere{0.5}) : at_rest(Box{Vec3::Constant(0.5)}));
  const double top = std::get<Box>(below.shape).half_extents.z() + 0.5;
  above.X_WB.p_WB = {0.25 * random.whole(-1, 1), 0, top + random.pick({0.0, 0x1p-20, 0.125, 0.5})};
  below.material = above.material = {random.pick({0.0, 0.25, 0.5}), random.pick({0.0, 0.5})};
  const int pushed = random.one_in(2) ? 1 : 0;
  std::vector<Body> bodies = {std::move(below), std::move(above)};
  if (pushed == 0) std::ranges::reverse(bodies);
  Scene scene = run(random, std::move(bodies), motion_until(1, 4));
  const Vec3 force(0, 0, -random.whole(1, 8));
  scene.motion->force_bound = 8;
  scene.motion->forces = {{0, pushed, force}};
  if (random.one_in(2)) scene.motion->forces.push_back({0.5, pushed, Vec3::Zero()});
  return scene;
}

/// A square bar that stands on one of its long edges, which is along y.
Body bar_on_edge(Random& random) {
  const double half = random.whole(1, 2), length = random.whole(1, 3);
  std::vector<Vec3> vertices;
  for (const double y : {-length, length}) {
    for (const Vec3& corner : {Vec3(half, y, 0), Vec3(0, y, half), Vec3(-half, y, 0), Vec3(0, y, -half)}) {
      vertices.push_back(corner);
    }
  }
  Body bar = with_mass(random, at_rest(oracle::truth::convex_hull(vertices)));
  bar.material = some_material(random);
  return bar;
}

/// Two bars whose edges come together, parallel and shifted along each other: they meet in a segment, or just miss.
Scene edge_on_edge(Random& random) {
  Body below = bar_on_edge(random), above = bar_on_edge(random);
  above.X_WB.p_WB = {random.one_in(4) ? random.whole(-1, 1) : 0, random.whole(-4, 4), 6};
  above.velocity.v_WBcm = {0, random.whole(-1, 1), -random.whole(4, 8)};
  if (random.one_in(3)) below = fixed(std::move(below));
  return turned_somehow(random, run(random, {std::move(below), std::move(above)}, motion_until(1, 4)));
}

/// Two bars whose edges cross at 2^-4 to 2^-47 of a radian: seen from the side they are one line, and touch in a point.
Scene hardly_parallel(Random& random) {
  Body below = bar_on_edge(random), above = bar_on_edge(random);
  const double turn = random.sign() * std::exp2(-random.between(5, 48));
  above.X_WB = {{turn * random.whole(-1, 1), random.whole(-2, 2), 6}, {1, 0, 0, turn}};
  above.velocity.v_WBcm = {0, 0, -random.whole(4, 8)};
  if (random.one_in(2)) below = fixed(std::move(below));
  return turned_somehow(random, run(random, {std::move(below), std::move(above)}, motion_until(1, 4)));
}

/// A box that falls on one of its corners, turning.
std::vector<Body> spinning(Random& random) {
  Body box = at_rest(Box{Vec3{random.whole(2, 4), random.whole(2, 3), random.whole(1, 2)} / 4});
  box.X_WB = {{0, 0, 1.5}, small_quaternion(random)};
  box.velocity.w_WB = Vec3{random.whole(-2, 2), random.whole(-2, 2), random.whole(2, 4)};
  return {std::move(box)};
}

/// Bodies on a level table without friction, which may rub on each other.
Scene on_ice(Random& random) {
  std::vector<Body> bodies = random.pick<Bodies>({sliders, on_another, dropped, spinning})(random);
  set_material(random, bodies);
  return on_large_table(random, std::move(bodies), 0, motion_until(2, 4));
}

/// Two bodies that start 2^4 to 2^60 of their sizes apart, and come within a few sizes or into contact halfway through
/// the motion. Positions and velocities are exact: one axis has the approach, the others have the offset.
Scene far_apart(Random& random) {
  Body a = random.one_in(3) ? some_box(random) : some_ball(random), b = some_ball(random);
  const double way = std::ldexp(std::max(size(a.shape), size(b.shape)), random.between(4, 60));
  a.material = b.material = some_material(random);
  if (random.one_in(4)) a = fixed(std::move(a));
  b.X_WB.p_WB = {way, 0.5 * random.whole(-3, 3), 0.5 * random.whole(-3, 3)};
  b.velocity.v_WBcm = {-2 * way, 0, 0};
  return turned_somehow(random, run(random, {std::move(a), std::move(b)}, motion_until(1, 2)));
}

}  // namespace

std::vector<Family> run_families() {
  const std::vector<std::string> queries = {"simulation"}, both = {"simulation", "constraint"};
  return {
      {"runs.balls", "balls that collide in the middle", both, true, balls},
      {"runs.solids", "two solids that collide in the middle", queries, true, solids},
      {"runs.elastic_balls", "the same for elastic, smooth balls", queries, true, elastic_balls},
      {"runs.on_a_table", "solids thrown onto a table", queries, true, on_a_table},
      {"runs.cradle", "equal balls in a row, with gaps", queries, true, cradle},
      {"runs.ties", "pairs that collide at the same time", queries, true, ties},
      {"runs.crowd", "20 to 60 balls that collide in pairs within 2^-5 s", queries, true, crowd},
      {"runs.one_impact", "two elastic, smooth bodies that collide once", queries, true, one_impact},
      {"runs.tops", "bodies whose moments differ, turning", both, true, tops},
      {"runs.pushed", "forces that begin and change", both, true, pushed},
      {"runs.apart", "bodies that never touch", both, true, apart},
      {"runs.at_rest", "balls and blocks at rest on a table", both, true, at_rest_on_a_table},
      {"runs.skims", "balls on a table that bounce within the envelope", queries, true, skims},
      {"runs.spins", "a ball that slides on a table and spins about the vertical", both, true, spins},
      {"runs.bouncing", "a ball that bounces, and comes to rest", both, true, bouncing},
      {"runs.falls_flat", "a box that falls flat, bounces, and comes to rest", both, true, falls_flat},
      {"runs.together", "one body that collides with two at one time", queries, true, together},
      {"runs.parts_land", "a compound that lands on several of its parts at one time", queries, true, parts_land},
      {"runs.parts_separate",
       "a compound that stands on several parts and turns, so that one hits and another separates", queries, true,
       parts_separate},
      {"runs.hardly_apart", "balls 2^-33 to 2^-44 apart in a row, hit from both sides at one time", queries, false,
       hardly_apart},
      {"runs.touching", "a row of balls that touch, hit at its ends; a polytope that lands on a face", queries, true,
       touching},
      {"runs.on_ice", "bodies that slide, fall and rub on each other on a table without friction", both, true, on_ice},
      {"runs.piles", "three bodies that rest on each other, rub, tip and fall", queries, true, piles},
      {"runs.carried", "bodies that slide on a box that moves, fixed or on ice", both, true, on_a_carrier},
      {"runs.onto_a_box", "a box that falls beside the middle of another one on ice", queries, true, onto_a_box},
      {"runs.pressed_together", "a ball or a box that a force presses on a free box", queries, false, pressed_together},
      {"runs.edge_on_edge", "bars whose parallel edges meet, shifted along each other", queries, true, edge_on_edge},
      {"runs.hardly_parallel", "bars whose edges meet and are hardly parallel", queries, false, hardly_parallel},
      {"runs.far_apart", "two bodies that start 2^4 to 2^60 sizes apart", queries, false, far_apart},
  };
}

}  // namespace touchstone::properties
