// A ball on tables: it slides, rolls, falls, rebounds. Also blocks and stacks, for which only laws are known, no exact
// answer. Asked of both ways to follow bodies in contact: simulation and constraint.
//
// Lengths are multiples of 2⁻⁴, and tilts are rotations with small integer quaternions, so that contacts touch exactly.
// Speeds are chosen such that something changes during the motion; in some families they are within 2⁻²⁰ of the value
// at which it would not.
#include <Eigen/Geometry>
#include <cmath>

#include "properties/scenes/families.h"
#include "properties/scenes/thrown.h"

namespace touchstone::properties {
namespace {

constexpr double g = 9.75;  // exact in floats

double sixteenths(Random& random, int lo, int hi) { return random.whole(lo, hi) / 16; }

/// The nearest multiple of 2^-bits: the same on every machine, like a square root.
double rounded(double x, int bits) { return std::ldexp(std::floor(std::ldexp(x, bits) + 0.5), -bits); }

Body plate(const Vec3& half, const Pose& X_WB, const Material& material) {
  return {"table", Box{half}, X_WB, {}, material, Fixed{}};
}

Material some_surface(Random& random) {
  return {random.pick({0.0, 0.0, 0.5}), random.pick({0.0, 0.0625, 0.125, 0.25, 0.5, 1.0})};
}

Mass some_mass(Random& random, double r) {
  if (random.one_in(2)) return Density{random.pick({1.0, 1000.0})};
  // A nearly hollow ball, one with a heavy core, and one in between.
  const double m = random.pick({0.5, 1.0, 4.0});
  return MassProperties{m, Vec3::Zero(), Mat3(random.pick({0.625, 0.25, 0.4375}) * m * r * r * Mat3::Identity())};
}

Body ball(Random& random, double r, const Vec3& p) {
  return {"ball", Sphere{r}, {p, {}}, {}, {1, 16}, some_mass(random, r)};
}

/// The angular velocity with which a ball of velocity v rolls on a face with normal n.
Vec3 rolling(const Vec3& v, const Vec3& n, double r) { return n.cross(v) / r; }

Motion sampled_at(double end) {
  Motion motion;
  for (int i = 1; i <= 8; ++i) motion.sample_times.push_back(end * i / 8);
  return motion;
}

Scene table_scene(Random& random, double r) {
  Scene scene;
  scene.gravity = Vec3(0, 0, -g);
  const Vec3 half{sixteenths(random, 32, 64), sixteenths(random, 32, 64), sixteenths(random, 8, 32)};
  scene.bodies = {ball(random, r, Vec3(0, 0, r)), plate(half, {Vec3(0, 0, -half.z()), {}}, some_surface(random))};
  return scene;
}

double some_radius(Random& random) { return random.pick({0.0625, 0.125, 0.25, 0.5}); }

/// Slides with spin about any axis, so that its path curves.
Scene slides(Random& random) {
  const double r = some_radius(random);
  Scene scene = table_scene(random, r);
  scene.bodies[1].material.friction = random.pick({0.0625, 0.125, 0.25, 0.5});
  const double vx = sixteenths(random, -24, 24), vy = sixteenths(random, -24, 24);
  scene.bodies[0].velocity.v_WBcm = Vec3(vx, vy, 0);
  const double wx = random.whole(-8, 8), wy = random.whole(-8, 8), wz = random.whole(-8, 8);
  scene.bodies[0].velocity.w_WB = Vec3(wx, wy, wz);
  scene.motion = sampled_at(random.pick({0.25, 0.5, 1.0}));
  return scene;
}

/// Rolls off the edge fast enough to leave it at once, and falls onto a floor.
Scene falls(Random& random) {
  const double r = some_radius(random);
  Scene scene = table_scene(random, r);
  const double least = rounded(std::sqrt(r * g), 4);
  const Vec3 v{least + sixteenths(random, 4, 48), random.one_in(2) ? 0 : sixteenths(random, -8, 8), 0};
  scene.bodies[0].velocity = {v, rolling(v, Vec3::UnitZ(), r)};
  const double floor = -sixteenths(random, 40, 80);
  scene.bodies.push_back(plate(Vec3(64, 64, 1), {Vec3(0, 0, floor - 1), {}}, some_surface(random)));
  if (random.one_in(4)) std::swap(scene.bodies[0], scene.bodies[2]);
  scene.motion = sampled_at(random.pick({1.0, 1.5, 2.0}));
  return scene;
}

/// Rolls over the edge with v² above g r by only 2⁻⁴ to 2⁻¹² of it.
Scene barely_flies(Random& random) {
  const double r = some_radius(random);
  Scene scene = table_scene(random, r);
  const double v = rounded(std::sqrt(r * g), 16) * (1 + std::ldexp(1.0, -random.between(1, 12)));
  const Vec3 velocity(rounded(v, 16) + 0x1p-16, 0, 0);
  scene.bodies[0].velocity = {velocity, rolling(velocity, Vec3::UnitZ(), r)};
  const double half = std::get<Box>(scene.bodies[1].shape).half_extents.x();
  scene.motion = sampled_at(rounded(1.25 * half / v, 4) + 0.0625);
  return scene;
}

/// A smooth ball that slides slowly into a smooth box.
Scene slow_obstacle(Random& random) {
  const double r = some_radius(random);
  Scene scene = table_scene(random, r);
  const double speed = sixteenths(random, 1, 4) / 4, h = sixteenths(random, 2, 8);
  scene.bodies.push_back(plate(Vec3(h, 1, h), {Vec3(r + h + speed / 4, 0, h), {}}, {random.pick({0.5, 0.75}), 0}));
  for (Body& body : scene.bodies) body.material.friction = 0;
  scene.bodies[0].velocity.v_WBcm = {speed, 0, 0};
  scene.motion = sampled_at(1);
  return scene;
}

/// A box on the table, in the ball's path.
Scene obstacle(Random& random) {
  const double r = some_radius(random);
  Scene scene = table_scene(random, r);
  const Vec3 v{sixteenths(random, 8, 48), random.one_in(2) ? 0 : sixteenths(random, -4, 4), 0};
  scene.bodies[0].velocity = {v, random.one_in(3) ? Vec3::Zero() : rolling(v, Vec3::UnitZ(), r)};
  const double hx = sixteenths(random, 2, 8), hz = sixteenths(random, 1, 16);
  const Material surface{random.pick({0.25, 0.5, 1.0}), random.pick({0.0, 0.0, 0.125, 0.5})};
  scene.bodies.push_back(plate(Vec3(hx, 1, hz), {Vec3(r + hx + sixteenths(random, 4, 12), 0, hz), {}}, surface));
  scene.motion = sampled_at(random.pick({0.5, 1.0}));
  return scene;
}

/// A face tilted about y: downhill is (c, 0, −s), with n = (s, 0, c), tan = s/c = 4/3, 3/4, 5/12 or 8/15.
struct Slope {
  Quaternion q;
  double c, s, over;  ///< cos = c/over, sin = s/over
};
constexpr Slope slopes[] = {
    {{2, 0, 1, 0}, 3, 4, 5}, {{3, 0, 1, 0}, 4, 3, 5}, {{5, 0, 1, 0}, 12, 5, 13}, {{4, 0, 1, 0}, 15, 8, 17}};

/// The ball at `along` · (c, 0, −s)/16 from the middle of the top face, touching it exactly: h + r is a multiple of
/// over/16.
Scene on_slope(Random& random, const Slope& slope, double along) {
  const double r = slope.over / 16 * random.pick({0.25, 0.5});
  const int steps = random.between(1, 3);
  const double h = steps * slope.over / 16 - r;
  const Vec3 n = Vec3(slope.s, 0, slope.c) / 16, down = Vec3(slope.c, 0, -slope.s) / 16;
  Scene scene;
  scene.gravity = Vec3(0, 0, -g);
  scene.bodies = {ball(random, r, steps * n + along * down),
                  plate(Vec3(slope.over / 4, 2, h), {Vec3::Zero(), slope.q}, some_surface(random))};
  return scene;
}

/// Slides and rolls uphill and downhill.
Scene slope(Random& random) {
  const Slope& tilt = slopes[random.below(4)];
  Scene scene = on_slope(random, tilt, random.between(-1, 1));
  const Vec3 down = Vec3(tilt.c, 0, -tilt.s) / 16;
  const double speed = random.whole(-6, 6) / 2;
  const double r = std::get<Sphere>(scene.bodies[0].shape).radius;
  const double spin = random.one_in(2) ? speed * tilt.over / 16 / r : random.whole(-6, 6);  // rolling, or arbitrary
  scene.bodies[0].velocity = {speed * down, Vec3(0, spin, 0)};
  scene.motion = sampled_at(random.pick({0.25, 0.5}));
  return scene;
}

/// Rolls uphill and reverses before the edge, by 2⁻⁶ to 2⁻³⁰ of the distance.
Scene barely_stays(Random& random) {
  const Slope& tilt = slopes[1 + random.below(3)];
  Scene scene = on_slope(random, tilt, 0);
  Body& rolls = scene.bodies[0];
  rolls.mass = Density{1};
  scene.bodies[1].material = {0, 2};
  const double r = std::get<Sphere>(rolls.shape).radius, half = tilt.over / 4;
  const double critical = std::sqrt(2 * 5.0 / 7 * g * tilt.s / tilt.over * half) / tilt.over;
  const double k =
      std::ldexp(std::floor(std::ldexp(critical * (1 - std::ldexp(1.0, -random.between(6, 30))), 34)), -34);
  rolls.velocity = {Vec3(-k * tilt.c, 0, k * tilt.s), Vec3(0, -k * tilt.over / r, 0)};
  scene.motion = sampled_at(random.pick({0.5, 1.0}));
  return scene;
}

/// Falls onto the table with spin; with restitution it falls again.
Scene drops(Random& random) {
  const double r = some_radius(random);
  Scene scene = table_scene(random, r);
  scene.bodies[1].material.friction = random.pick({0.0625, 0.125, 0.25, 0.5});
  scene.bodies[0].X_WB.p_WB.z() += sixteenths(random, 1, 16);
  const double vx = sixteenths(random, -16, 16), wy = random.whole(-16, 16), wx = random.whole(-4, 4);
  scene.bodies[0].velocity = {Vec3(vx, 0, 0), Vec3(wx, wy, 0)};
  scene.motion = sampled_at(random.pick({0.5, 0.75}));
  return scene;
}

/// Thrown up against a ceiling that it just reaches, or just does not, early in a long motion.
Scene ceiling(Random& random) {
  const double r = random.pick({0.5, 1.0, 2.0});
  Scene scene = table_scene(random, r);
  Body& ball = scene.bodies[0];
  ball.X_WB.p_WB.z() += sixteenths(random, 1, 4);
  const double soon = sixteenths(random, 1, 4), apex = g * soon * soon / 2;
  const double beyond = random.one_in(4) ? 1 : -1;
  const double rise = rounded(apex * (1 + std::ldexp(beyond, -random.between(1, 4))), 24);
  ball.velocity.v_WBcm = {sixteenths(random, -4, 4), 0, g * soon};
  const Vec3 half(16, 16, 0.5);
  scene.bodies.push_back(plate(half, {ball.X_WB.p_WB + Vec3(0, 0, r + rise + half.z()), {}}, some_surface(random)));
  scene.motion = Motion{.sample_times = {2 * soon, 4 * soon, 4}};
  return scene;
}

Body block(const Vec3& half, const Pose& X_WB, double density) {
  return {"block", Box{half}, X_WB, {}, {0, 0.5}, Density{density}};
}

/// A block on a slope, with friction close to the tangent of its angle.
Scene block_on_slope(Random& random) {
  const Slope& tilt = slopes[random.below(4)];
  Scene scene = on_slope(random, tilt, 0);
  const double r = std::get<Sphere>(scene.bodies[0].shape).radius;
  const Pose X_WB{scene.bodies[0].X_WB.p_WB, tilt.q};
  scene.bodies[0] = block(Vec3(2 * r, r, r), X_WB, 1);
  const int side = random.sign();
  scene.bodies[0].material.friction =
      rounded(tilt.s / tilt.c * (1 + side * std::ldexp(1.0, -random.between(1, 8))), 16);
  scene.bodies[1].material = {0, 16};
  scene.motion = sampled_at(0.25);
  return scene;
}

/// A block that stands on a slope and cannot slide: its width is between an eighth of its height and twice that, so
/// that it tips or stands.
Scene tips(Random& random) {
  const Slope& tilt = slopes[random.below(4)];
  Scene scene = on_slope(random, tilt, random.between(-1, 1));
  const double r = std::get<Sphere>(scene.bodies[0].shape).radius;
  const double width = r * random.pick({0.125, 0.25, 0.5, 1.0, 2.0});
  scene.bodies[0] = block(Vec3(width, r, r), {scene.bodies[0].X_WB.p_WB, tilt.q}, 1);
  for (Body& body : scene.bodies) body.material = {0, 2};
  scene.motion = sampled_at(random.pick({0.125, 0.25}));
  return scene;
}

/// A block that slides down a slope or up it, where friction stops it or does not.
Scene block_slides(Random& random) {
  const Slope& tilt = slopes[random.below(4)];
  Scene scene = on_slope(random, tilt, random.between(-1, 1));
  const double r = std::get<Sphere>(scene.bodies[0].shape).radius;
  scene.bodies[0] = block(Vec3(2 * r, r, r), {scene.bodies[0].X_WB.p_WB, tilt.q}, 1);
  const double friction = rounded(tilt.s / tilt.c * random.pick({0.25, 0.75, 1.25, 2.0}), 16);
  for (Body& body : scene.bodies) body.material = {0, friction};
  const Vec3 down = Vec3(tilt.c, 0, -tilt.s) / 16;
  scene.bodies[0].velocity.v_WBcm = random.whole(-4, 4) * down;
  scene.motion = sampled_at(random.pick({0.25, 0.5}));
  return scene;
}

/// Rolls down from rest or with a push, and leaves the lower edge.
Scene slope_end(Random& random) {
  const Slope& tilt = slopes[random.below(4)];
  Scene scene = on_slope(random, tilt, random.between(1, 3));
  const Vec3 down = Vec3(tilt.c, 0, -tilt.s) / 16;
  const double speed = random.one_in(2) ? 0 : random.whole(0, 6) / 2;
  const double r = std::get<Sphere>(scene.bodies[0].shape).radius;
  scene.bodies[0].velocity = {speed * down, Vec3(0, speed * tilt.over / 16 / r, 0)};
  scene.bodies[1].material.friction = random.pick({0.125, 0.5, 2.0});
  scene.motion = sampled_at(random.pick({1.0, 1.5}));
  return scene;
}

/// A ball or a block in the corner of a slope and a wall at its lower end, or that slides down to the wall. At rest the
/// two normals differ, so forces that would hold a body which sticks at both may be outside of its friction cones.
Scene corner(Random& random) {
  const Slope& tilt = slopes[random.below(4)];
  Scene scene = on_slope(random, tilt, 0);
  const double r = std::get<Sphere>(scene.bodies[0].shape).radius, unit = tilt.over / 16;
  if (random.one_in(2)) scene.bodies[0] = block(Vec3(r, 2 * r, r), {scene.bodies[0].X_WB.p_WB, tilt.q}, 1);
  const double friction = random.pick({0.0, 0.125, 0.25, 0.5, 1.0});
  for (Body& body : scene.bodies) body.material = {random.pick({0.0, 0.0, 0.5}), friction};
  // The wall begins r from the middle of the body, or one or two units farther.
  const int beside = random.pick({1, 1, 2, 3}), above = random.between(0, 1);
  const Vec3 n = Vec3(tilt.s, 0, tilt.c) / 16, down = Vec3(tilt.c, 0, -tilt.s) / 16;
  if (beside > 1) scene.bodies[0].velocity.v_WBcm = random.whole(0, 8) * down;
  const Vec3 middle = scene.bodies[0].X_WB.p_WB + beside * down + above * n;
  scene.bodies.push_back(plate(Vec3(unit - r, 2, 2 * unit), {middle, tilt.q}, {0, friction}));
  scene.motion = sampled_at(random.pick({0.25, 0.5}));
  return scene;
}

/// Boxes on boxes, each up to a hundred times as heavy as the one below.
Scene stack(Random& random) {
  Scene scene;
  scene.gravity = Vec3(0, 0, -g);
  scene.bodies = {plate(Vec3(4, 4, 1), {Vec3(0, 0, -1), {}}, {0, 0.5})};
  double top = 0;
  const int count = random.between(2, 3);
  for (int i = 0; i < count; ++i) {
    const double hz = sixteenths(random, 4, 8), x = sixteenths(random, -2, 2), y = sixteenths(random, -2, 2);
    const double density = random.pick({1.0, 1.0, 10.0, 100.0});
    scene.bodies.push_back(block(Vec3(0.5, 0.5, hz), {Vec3(x, y, top + hz), {}}, density));
    top += 2 * hz;
  }
  scene.motion = sampled_at(0.25);
  return scene;
}

/// Blocks at rest that hang over two edges of the table: the centre of mass of one is inside by 1/2 to 2⁻¹² of its half
/// length, that of the other outside.
Scene overhangs(Random& random) {
  Scene scene = table_scene(random, 0.5);
  const double edge = std::get<Box>(scene.bodies[1].shape).half_extents.x();
  scene.bodies[1].material = {0, random.pick({0.25, 0.5, 1.0})};
  scene.bodies.erase(scene.bodies.begin());
  const Vec3 half{sixteenths(random, 4, 16), sixteenths(random, 4, 16), sixteenths(random, 4, 16)};
  const int side_of_edge = random.sign();
  const double beside = side_of_edge * std::ldexp(half.x(), -random.between(1, 12));
  for (const double side : {-1.0, 1.0}) {
    scene.bodies.push_back(block(half, {Vec3(side * edge + beside, 0, half.z()), {}}, 1));
  }
  scene.motion = sampled_at(1);
  return scene;
}

/// A block that lies half over the edge of a table, and tips over it at once.
Scene topples(Random& random) {
  Scene scene = table_scene(random, 0.5);
  const double edge = std::get<Box>(scene.bodies[1].shape).half_extents.x();
  scene.bodies[1].material = {0, random.pick({0.0625, 0.25, 0.5, 1.0})};
  const Vec3 half{sixteenths(random, 4, 16), sixteenths(random, 4, 16), sixteenths(random, 1, 8)};
  const double beside = half.x() * random.pick({0.25, 0.5, 0.75});
  scene.bodies[0] = block(half, {Vec3(random.sign() * (edge + beside), 0, half.z()), {}}, 1);
  scene.motion = sampled_at(random.pick({0.5, 1.0}));
  return scene;
}

/// A ball or a block at rest on a table, pushed along it by forces that begin and change.
Scene pushed(Random& random) {
  const double r = some_radius(random);
  Scene scene = table_scene(random, r);
  scene.bodies[1].material.friction = random.pick({0.0625, 0.125, 0.25});
  if (random.one_in(2)) scene.bodies[0] = block(Vec3(2 * r, 2 * r, r), {Vec3(0, 0, r), {}}, 1);
  scene.bodies[0].mass = Density{1};
  scene.motion = sampled_at(0.5);
  const double volume = 32 * r * r * r;  // of the block
  scene.motion->force_bound = 16 * volume;
  double time = random.pick({0.0, 0.0625, 0.1});
  for (int i = random.between(1, 3); i > 0; --i) {
    const Vec3 along{random.whole(-8, 8), random.whole(-8, 8), 0};
    scene.motion->forces.push_back({time, 0, volume * along});
    time += sixteenths(random, 1, 2);
  }
  return scene;
}

/// A ball, or a ball and a block that may collide, without a table, pushed by forces that begin and change.
Scene adrift(Random& random) {
  const double r = some_radius(random);
  Scene scene = table_scene(random, r);
  scene.bodies.pop_back();
  scene.bodies[0].mass = Density{1};
  scene.bodies[0].velocity.v_WBcm = {sixteenths(random, -16, 16), 0, sixteenths(random, -16, 16)};
  if (random.one_in(3)) {
    scene.bodies[0].mass = MassProperties{8 * r * r * r, Vec3::Zero(), r * r * r * r * r * unlike_moments(random)};
    scene.bodies[0].velocity.w_WB = Vec3(4, 0.5, 1);
  }
  if (random.one_in(2)) {
    scene.bodies.push_back(block(Vec3(r, r, r), {Vec3(4 * r, 0, r), {}}, 1));
    scene.bodies[1].material.restitution = random.pick({0.0, 0.5});
  }
  if (random.one_in(3)) scene.gravity.setZero();
  const double longer = random.pick({1.0, 1.0, 8.0});
  scene.motion = sampled_at(0.5 * longer);
  if (random.one_in(3)) return scene;
  const double volume = 8 * r * r * r;
  scene.motion->force_bound = 64 * volume;
  double time = longer * random.pick({0.0, 0.0625, 0.1});
  for (int i = random.between(1, 3); i > 0; --i) {
    const Vec3 force{random.whole(-16, 16), random.whole(-1, 1), random.whole(-4, 4)};
    scene.motion->forces.push_back({time, random.below(static_cast<int>(scene.bodies.size())), volume * force});
    time += longer * sixteenths(random, 1, 2);
  }
  return scene;
}

/// A ball with its centre of mass off its middle falls on a table or on a fixed ball, and may spin.
Scene eccentric(Random& random) {
  const double r = some_radius(random), m = random.pick({0.5, 1.0, 4.0});
  Scene scene = table_scene(random, r);
  const Vec3 off = r * random.pick<Vec3>({{0, 0, 0.875}, {0, 0, -0.75}, {0.5, 0, 0.5}, {0, -0.75, 0}});
  scene.bodies[0].mass = MassProperties{m, off, Mat3(random.pick({0.125, 0.25}) * m * r * r * Mat3::Identity())};
  const double height = 0.5 * r * random.whole(1, 8), lasts = std::sqrt(2 * height / g);
  scene.bodies[0].X_WB.p_WB.z() += height;
  if (random.one_in(2)) scene.bodies[0].velocity.v_WBcm.x() = sixteenths(random, -8, 8);
  if (random.one_in(2)) scene.bodies[0].velocity.w_WB = {0, random.whole(-8, 8), random.whole(-2, 2)};
  if (random.one_in(2)) {
    scene.bodies[1].shape = Sphere{r};
    scene.bodies[1].X_WB.p_WB = {0, 0, -r};
  }
  // Soon after it has landed, and no sample before ends a long step.
  scene.motion = Motion{.sample_times = {rounded(random.pick({1.0625, 1.25, 1.5}) * lasts, 8)}};
  return scene;
}

/// Where a side of a table is cut: one to `most` places in the quarter around its middle, where bodies start.
std::vector<double> cuts(Random& random, double half, int most) {
  std::vector<double> at{-half};
  int place = random.between(-4, 4);  // sixteenths
  for (int count = random.between(1, most); count > 0 && place <= 4; --count) {
    at.push_back(half * place / 16);
    place += random.between(1, 4);
  }
  at.push_back(half);
  return at;
}

/// The table in parts, like tiles, that end where it is cut.
Body in_tiles(Body table, const std::vector<double>& x, const std::vector<double>& y) {
  const Vec3 half = std::get<Box>(table.shape).half_extents;
  Compound tiles;
  for (std::size_t i = 1; i < x.size(); ++i) {
    for (std::size_t j = 1; j < y.size(); ++j) {
      const Vec3 middle{(x[i - 1] + x[i]) / 2, (y[j - 1] + y[j]) / 2, 0};
      tiles.parts.push_back({{middle, {}}, Box{{(x[i] - x[i - 1]) / 2, (y[j] - y[j - 1]) / 2, half.z()}}});
    }
  }
  table.shape = tiles;
  return table;
}

std::vector<double> across(Random& random, double half) {
  return random.one_in(3) ? cuts(random, half, 1) : std::vector<double>{-half, half};
}

/// A block that slides along a level table, over a seam that is a part of its way ahead.
Scene block_over_a_seam(Random& random) {
  const double r = some_radius(random), end = random.pick({0.25, 0.5});
  Scene scene = table_scene(random, r);
  scene.bodies[0] = block(Vec3(2 * r, 2 * r, r), {Vec3(0, 0, r), {}}, 1);
  for (Body& body : scene.bodies) body.material = {0, random.pick({0.0, 0.0625, 0.125, 0.25})};
  const double vx = sixteenths(random, 8, 24), vy = sixteenths(random, -24, 24);
  scene.bodies[0].velocity.v_WBcm = {vx, vy, 0};
  const Vec3 half = std::get<Box>(scene.bodies[1].shape).half_extents;
  const double seam = 2 * r + vx * end * random.pick({0.125, 0.25, 0.5});
  scene.bodies[1] = in_tiles(scene.bodies[1], {-half.x(), seam, half.x()}, across(random, half.y()));
  scene.motion = sampled_at(end);
  return scene;
}

/// A ball or a block on a table that is cut at random.
Scene on_tiles(Random& random) {
  using Draw = Scene (*)(Random&);
  Scene scene = random.pick<Draw>({slides, slope, drops, block_slides})(random);
  for (Body& body : scene.bodies) {
    if (!is_fixed(body)) continue;
    const Vec3 half = std::get<Box>(body.shape).half_extents;
    const std::vector<double> x = cuts(random, half.x(), 3);
    body = in_tiles(body, x, across(random, half.y()));
  }
  return scene;
}

/// A ball that bounces within the envelope, on its way over a seam: so subjects that know no resting contact may answer
/// too.
Scene skims_over_a_seam(Random& random) {
  Scene scene = table_scene(random, 1);
  for (Body& body : scene.bodies) body.material = {1, random.pick({0.25, 0.5})};
  scene.bodies[0].X_WB.p_WB.z() += 0x1p-12;
  const double speed = random.whole(1, 4);
  scene.bodies[0].velocity.v_WBcm = {speed, 0, 0};
  const Vec3 half = std::get<Box>(scene.bodies[1].shape).half_extents;
  const std::vector<double> x = {-half.x(), speed / 16, half.x()};
  scene.bodies[1] = in_tiles(scene.bodies[1], x, {-half.y(), half.y()});
  scene.motion = sampled_at(0.125);
  scene.motion->envelope = 0x1p-11;
  return scene;
}

Scene tiles(Random& random) {
  using Draw = Scene (*)(Random&);
  return random.pick<Draw>({block_over_a_seam, block_over_a_seam, on_tiles, skims_over_a_seam})(random);
}

}  // namespace

std::vector<Family> table_families() {
  const std::vector<std::string> queries = {"simulation", "constraint"};
  return {
      {"tables.slides", "a ball that slides on a table, with spin", queries, true, slides},
      {"tables.falls", "a ball that rolls off a table onto a floor", queries, false, falls},
      {"tables.barely_flies", "a ball over the edge, v² above g r by a half to 2^-12 of it", queries, false,
       barely_flies},
      {"tables.slow_obstacle", "a smooth ball that slides slowly into a smooth box", queries, true, slow_obstacle},
      {"tables.obstacle", "a box in the ball's way", queries, false, obstacle},
      {"tables.slope", "a ball that slides or rolls on a tilted table", queries, false, slope},
      {"tables.barely_stays", "a ball that turns just before the upper edge", queries, false, barely_stays},
      {"tables.drops", "a ball that falls on a table with spin", queries, true, drops},
      {"tables.ceiling", "a ball thrown up against a ceiling that it just reaches or not", queries, false, ceiling},
      {"tables.block", "a block on a slope, friction near the tangent", queries, false, block_on_slope},
      {"tables.tips", "a block that stands on a slope, and tips or not", queries, false, tips},
      {"tables.block_slides", "a block that slides on a slope, stops or does not", queries, false, block_slides},
      {"tables.slope_end", "a ball that rolls down a slope and leaves it", queries, false, slope_end},
      {"tables.corner", "a ball or a block at the lower end of a slope, at a wall or on its way there", queries, false,
       corner},
      {"tables.overhangs", "blocks at rest over two edges of a table", queries, true, overhangs},
      {"tables.topples", "a block half over the edge of a table, which tips over it", queries, true, topples},
      {"tables.pushed", "a ball or a block on a table, pushed by forces that begin and change", queries, false, pushed},
      {"tables.adrift", "a ball, perhaps with a block, without a table, pushed by forces", queries, false, adrift},
      {"tables.eccentric", "a ball with its centre of mass off its middle falls on a table or a ball", queries, false,
       eccentric},
      {"tables.tiles", "a ball or a block that slides over the seams of a table", {"simulation"}, false, tiles},
      {"tables.stack", "two or three boxes on each other, the upper up to 100 times as heavy", queries, false, stack},
  };
}

}  // namespace touchstone::properties
