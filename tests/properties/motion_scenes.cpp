#include "tests/properties/motion_scenes.h"

#include <utility>

#include "model/box_vertices.h"
#include "oracle/truth/truth.h"
#include "tests/properties/scenes.h"

namespace touchstone::tests {
namespace {

const Box cube{Vec3(1, 1, 1)};
const Box brick{Vec3(1, 2, 0.5)};
const Polytope wedge{{{3, 1, 1}, {5, 1, 1}, {3, 2, 1}, {3, 1, 4}, {5, 2, 3}}, {}};
const Quaternion skew{3, 1, -2, 1};
const Vec3 still(0, 0, 0);

Body moving(Body body, const Vec3& v, const Vec3& w = still) {
  body.velocity = {v, w};
  return body;
}

Body unmoved(Body body) {
  body.mass = Fixed{};
  return body;
}

Body with(Body body, double e, double mu) {
  body.material = {e, mu};
  return body;
}

/// The body with the given principal moments of inertia.
Body top(Body body, const Vec3& moments) {
  MassProperties given;
  given.mass = 2;
  given.I_BBcm_B = moments.asDiagonal();
  body.mass = given;
  return body;
}

Scene scene_of(const std::string& name, std::vector<Body> bodies, std::vector<double> times, const Vec3& gravity) {
  Scene scene;
  scene.name = name;
  scene.bodies = std::move(bodies);
  scene.gravity = gravity;
  scene.motion.emplace();
  scene.motion->sample_times = std::move(times);
  return oracle::truth::completed(scene);
}

Scene moving_pair(const std::string& name, Body a, Body b, double end, const Vec3& gravity = still) {
  return scene_of(name, {std::move(a), std::move(b)}, {end}, gravity);
}

Scene since(Scene scene, double a, double b) {
  scene.motion->start_times = {a, b};
  return scene;
}

Scene pushed(Scene scene, double bound, std::vector<AppliedForce> pushes) {
  scene.motion->force_bound = bound;
  scene.motion->forces = std::move(pushes);
  return scene;
}

const Body floor_box = unmoved(body(Box{Vec3(8, 8, 1)}, {0, 0, -1}));
const Vec3 down(0, 0, -8);

std::vector<Scene> build_motion_scenes() {
  const Body ball = body(Sphere{1}, {0, 0, 8});
  return {
      moving_pair("a cube that comes along y", moving(body(cube, {0, 0, 0}), {0, 4, 0}), body(cube, {0.5, 8, 0.25}), 4),
      moving_pair("a cube that comes along y, the other way", moving(body(cube, {0.5, 8, 0.25}), {0, -4, 0}),
                  body(cube, {0, 0, 0}), 4),
      moving_pair("cubes that turn and meet", moving(body(cube, {0, 0, 0}, skew), {3, 0, 0}, {1, 2, -1}),
                  moving(body(cube, {8, 1, 0.5}), {-1, 0, 0}, {0, 0, 2}), 4),
      moving_pair("a ball thrown at a table", moving(ball, {1, 0, 2}, {0, 3, 0}), floor_box, 4, down),
      moving_pair("balls in common gravity", moving(ball, {1, 0, -4}, {0, 1, 2}),
                  moving(body(Sphere{2}, {2, 0, 0}), {0, 0, 1}), 2, down),
      moving_pair("a shot through a thin plate", moving(body(Sphere{0.25}, {-16, 0.5, 0}), {512, 0, 0}),
                  body(Box{Vec3(0x1p-8, 4, 4)}, {0, 0, 0}), 1),
      moving_pair("cubes that touch and part", body(cube, {0, 0, 0}), moving(body(cube, {2, 0.5, 0}), {3, 1, 0}), 2),
      moving_pair("cubes that touch and approach", body(cube, {0, 0, 0}), moving(body(cube, {2, 0.5, 0}), {-3, 1, 0}),
                  2),
      moving_pair("a ball thrown off a table, and back", moving(body(Sphere{1}, {0, 0, 1}), {1, 0, 4}), floor_box, 2,
                  down),
      moving_pair("tops that meet", moving(top(body(brick, {0, 0, 0}), {2, 3, 4}), {32, 0, 0}, {1, 2, 1}),
                  body(cube, {6, 1.5, 0}), 0.25),
      moving_pair("a ball that passes", moving(body(Sphere{1}, {-8, 2.25, 0}), {4, 0, 0}), body(Sphere{1}, {0, 0, 0}),
                  4),
      moving_pair("balls that fly apart", moving(body(Sphere{1}, {-2, 0, 0}), {-4, 0, 0}), body(Sphere{1}, {2, 1, 0}),
                  2),
      moving_pair("an arm that turns", moving(unmoved(body(Box{Vec3(6, 0.5, 0.5)}, {0, 0, 0})), {0.5, 0, 0}, {0, 0, 1}),
                  body(Sphere{0.5}, {0, 4, 0}), 4),
      since(moving_pair("cubes from times of their own", moving(body(cube, {0, 0, 0}), {0, 4, 0}),
                        moving(body(brick, {0.5, 9, 0.25}), {0, -1, 0}), 4),
            0.25, 0.75),
      pushed(moving_pair("a push that turns it back", moving(body(cube, {0, 0, 0}), {4, 0, 0}),
                         body(cube, {-8, 0.5, 0.25}), 4),
             64, {{0, 0, {-32, 0, 0}}}),
      moving_pair("a wedge that falls", moving(body(wedge, {-4, -1, 4}, skew), {0, 1, -1}), floor_box, 2, down),
  };
}

std::vector<Scene> build_runs() {
  const Body ball = with(body(Sphere{1}, {0, 0, 0}), 1, 0);
  const auto at = [&](double x, double y, double z) {
    Body moved = ball;
    moved.X_WB.p_WB = {x, y, z};
    return moved;
  };
  Scene resting =
      scene_of("a cube and a ball at rest",
               {with(floor_box, 0.5, 0.5), body(cube, {-3, 0, 1 + 0x1p-12}), body(Sphere{1}, {3, 0, 1 + 0x1p-12})},
               {1, 2}, still);
  resting.motion->envelope = 0x1p-11;
  Scene bouncing =
      scene_of("balls that bounce within the envelope: one slides, one stays",
               {with(floor_box, 1, 0.25), with(moving(body(Sphere{1}, {0, 0, 1 + 0x1p-12}), {2, 0, 0}), 1, 1),
                with(body(Sphere{1}, {0, 5, 1 + 0x1p-12}), 1, 0.25)},
               {0.03125, 0.0625}, down);
  bouncing.motion->envelope = 0x1p-11;
  Scene spinning = scene_of(
      "a ball that spins about the vertical and slides, in bounces within the envelope",
      {with(floor_box, 1, 0.25), with(moving(body(Sphere{1}, {0, 0, 1 + 0x1p-18}), {2, 0, 0}, {0, 0, 64}), 1, 0.25)},
      {0.03125, 0.0625}, down);
  spinning.motion->envelope = 0x1p-17;
  Scene carried = scene_of("a ball that slides on a box which moves, in bounces within the envelope",
                           {with(moving(floor_box, {1, -0.5, 0}), 1, 0.25),
                            with(moving(body(Sphere{1}, {0, 0, 1 + 0x1p-18}), {3, 0.5, 0}), 1, 1)},
                           {0.03125, 0.0625}, down);
  carried.motion->envelope = 0x1p-17;
  const Compound tiles{{{{{-4, 0, 0}, {}}, Box{{4, 8, 1}}}, {{{4, 0, 0}, {}}, Box{{4, 8, 1}}}}};
  Scene over_a_seam = scene_of("a ball that slides over the seam of a floor, in bounces within the envelope",
                               {with(unmoved(body(tiles, {0, 0, -1})), 1, 0.25),
                                with(moving(body(Sphere{1}, {-0x1p-5, 0, 1 + 0x1p-12}), {2, 0, 0}), 1, 1)},
                               {0.03125, 0.0625}, down);
  over_a_seam.motion->envelope = 0x1p-11;
  return {
      scene_of("balls that rub",
               {with(moving(body(Sphere{1}, {0, 0, 0}), {3, 0, 0}, {0, 0, 4}), 0.5, 0.25),
                with(moving(body(Sphere{2}, {8, 1, 0.5}), {-1, 0, 0}, {1, 0, 0}), 1, 0.5)},
               {1, 2, 4}, still),
      scene_of("a cradle", {moving(at(-4, 0, 0), {4, 0, 0}), at(0, 0, 0), at(2.5, 0, 0)}, {0.25, 1, 2}, still),
      scene_of("a cube that falls on its corner",
               {with(moving(body(cube, {0, 0, 4}, skew), {1, 0, -2}, {0, 1, 0}), 0.5, 0.25), with(floor_box, 1, 1)},
               {0.25, 0.5}, down),
      scene_of("a top and a ball",
               {with(moving(top(body(brick, {0, 0, 0}), {2, 3, 4}), {32, 0, 0}, {1, 2, 1}), 0.75, 0),
                with(moving(body(Sphere{1}, {6, 1, 0}), {0, 0, 0}), 0.75, 0)},
               {0.0625, 0.25}, still),
      scene_of("a brick that turns about its middle axis, almost, and falls",
               {with(moving(body(Box{Vec3(0.5, 0.25, 0.125)}, {0, 0, 1.5}), {0, 0, 0}, {0x1p-7, 100, 0}), 0.5, 0),
                with(floor_box, 0.5, 0)},
               {0.25, 0.5}, down),
      scene_of("two pairs at one time",
               {moving(at(-3, 0, 0), {2, 0, 0}), moving(at(3, 0, 0), {-2, 0, 0}), moving(at(-3, 5, 0), {2, 0, 0}),
                moving(at(3, 5, 0), {-2, 0, 0})},
               {0.5, 2}, still),
      pushed(scene_of("a ball that is pushed", {moving(at(0, 0, 0), {2, 0, 0}), at(8, 0.5, 0)}, {0.5, 1, 3}, still), 16,
             {{0.25, 0, {8, 0, 0}}, {0.75, 1, {0, 4, 0}}}),
      scene_of("tops that never meet",
               {moving(top(body(brick, {0, 0, 0}), {2, 3, 4}), {-4, 0, 1}, {1, 2, 1}),
                moving(top(body(cube, {8, 0, 0}), {2, 2, 3}), {4, 0, 1}, {1, 0, 2})},
               {0.125, 0.25}, down),
      resting,
      bouncing,
      spinning,
      scene_of("a cube that hangs over an edge", {floor_box, body(cube, {8.5, 0, 1})}, {0.5, 1}, down),
      scene_of("a ball that bounces", {with(floor_box, 1, 0), with(body(Sphere{1}, {0, 0, 2}), 0.5, 0)},
               {0.25, 0.75, 1.25}, down),
      scene_of("a cube that falls flat", {with(floor_box, 1, 0), with(body(cube, {0, 0, 2}), 0.5, 0)},
               {0.25, 0.75, 1.25}, down),
      scene_of("balls that bounce on ice, and rub on each other",
               {with(moving(body(Sphere{1}, {-1.75, 0, 2}), {2, 0, 0}, {0, 0, 4}), 0.5, 0.25),
                with(body(Sphere{1}, {1.75, 0.5, 2}), 0.5, 0.25),
                with(unmoved(body(Box{Vec3(64, 64, 1)}, {0, 0, -1})), 1, 0)},
               {0.25, 0.875}, down),
      scene_of("a ball against a wall", {moving(at(0.5, 0, 8), {1, 0, -8}), with(floor_box, 1, 0)}, {0.5, 1.5}, still),
      scene_of("a ball that hits two at one time",
               {moving(at(-3, 0, 0), {4, 0, 0}), at(0.5, 1.25, 0), at(0.5, -1.25, 0)}, {0.25, 1.5}, still),
      scene_of("a polytope that lands on a face",
               {with(floor_box, 1, 0), with(moving(body(as_polytope(cube), {0, 0, 2}), {0, 0, -2}), 0.5, 0)},
               {0.25, 0.75}, still),
      carried,
      over_a_seam,
      scene_of("a ball from 2^24 radii away", {at(0, 0, 0), moving(at(0x1p24, 1, 0), {-0x1p25, 0, 0})}, {0.25, 1},
               still),
  };
}

}  // namespace

const std::vector<Scene>& motion_scenes() {
  static const std::vector<Scene> all = build_motion_scenes();
  return all;
}

const std::vector<Scene>& runs() {
  static const std::vector<Scene> all = build_runs();
  return all;
}

}  // namespace touchstone::tests
