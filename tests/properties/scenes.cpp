#include "tests/properties/scenes.h"

#include <algorithm>
#include <stdexcept>

#include "oracle/truth/truth.h"
#include "tests/properties/motion_scenes.h"

namespace touchstone::tests {
namespace {

const Box cube{Vec3(1, 1, 1)};
const Box brick{Vec3(1, 2, 0.5)};
const Polytope tetrahedron{{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}}, {}};
const Polytope octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
const Polytope wedge{{{3, 1, 1}, {5, 1, 1}, {3, 2, 1}, {3, 1, 4}, {5, 2, 3}}, {}};  // off its origin, without symmetry
const Polytope needle{{{0, 0, 0}, {1024, 1, 0}, {1024, 0, 1}, {1025, 1, 1}}, {}};
const Polytope nearly_level{{{-0.5, 0, 0}, {0.5, 0, 0x1p-41}, {0, 1, 4}, {0, -1, 4}}, {}};
const Quaternion about_x{2, 1, 0, 0};  // cos = 3/5, sin = 4/5
const Quaternion about_y{2, 0, 1, 0};
const Quaternion skew{3, 1, -2, 1};

Compound corner() {
  return {{{Pose{{0, 0, 0}, {}}, Box{Vec3(2, 0.5, 0.5)}}, {Pose{{1.5, 2, 0}, {}}, Box{Vec3(0.5, 2, 0.5)}}}};
}

Scene many(const std::string& name, std::vector<Body> bodies) {
  Scene scene;
  scene.name = name;
  scene.bodies = std::move(bodies);
  return oracle::truth::completed(scene);
}

Body dense(Body body, double density) {
  body.mass = Density{density};
  return body;
}

Body unmoved(Body body) {
  body.mass = Fixed{};
  return body;
}

Pose at(double x, double y, double z) { return {{x, y, z}, {}}; }

Scene sequence(const std::string& name, const std::vector<Shape>& shapes, std::vector<SequenceFrame> frames) {
  Scene scene;
  scene.name = name;
  for (const Shape& shape : shapes) scene.bodies.push_back(body(shape, {0, 0, 0}));
  scene.frames = std::move(frames);
  return oracle::truth::completed(scene);
}

Body moving(Body body, const Vec3& v, const Vec3& w) {
  body.velocity = {v, w};
  return body;
}

Body heavy(Body body, double mass, const Vec3& moments) {
  MassProperties given;
  given.mass = mass;
  given.I_BBcm_B = moments.asDiagonal();
  body.mass = given;
  return body;
}

const Body ground = unmoved(body(Box{Vec3(8, 8, 1)}, {0, 0, -1}));

/// An impact of the bodies at C, with the normal upward.
Scene impact(const std::string& name, Body a, Body b, const Vec3& p_WC, Law law, double e, double mu) {
  Scene scene = pair(name, std::move(a), std::move(b));
  scene.contact = Contact{p_WC, {0, 0, 1}, law, e, mu};
  return scene;
}

/// A rod in contact at r from its centre, with a body that is fixed: K as in the planar examples of the literature.
Body rod(const Vec3& r, double moment, const Vec3& v) {
  return moving(heavy(body(cube, -r), 1, Vec3::Constant(moment)), v, {0, 0, 0});
}

std::vector<Scene> build_impacts() {
  const Body left = moving(dense(body(brick, {1, 2, 3.5}), 2), {3, 1, -4}, {1, -2, 3});
  const Body right = moving(dense(body(cube, {1.5, 1, 2}), 1), {-1, 2, 1}, {2, 1, -1});
  const Vec3 between{1.5, 1.5, 3};
  const Body turned_left = moving(dense(body(brick, {1, 2, 3.5}, about_x), 2), {3, 1, -4}, {1, -2, 3});
  const Body ball = moving(heavy(body(Sphere{1}, {0, 0, 1}), 1, Vec3::Constant(0.5)), {3, 1, -1}, {0, 0, 0});
  const Body other_ball = moving(dense(body(Sphere{1}, {0, 0, -1}), 1), {1, 0, 2}, {0, 1, 0});
  const Body slow_ball = moving(heavy(body(Sphere{1}, {0, 0, 1}), 1, Vec3::Constant(0.5)), {0.25, 0, -0.25}, {0, 0, 0});
  const Body dropped = moving(heavy(body(Sphere{1}, {0, 0, 1}), 1, Vec3::Constant(0.5)), {0, 0, -1}, {0, 0, 0});
  const Body spinning = moving(heavy(body(Sphere{1}, {0, 0, 1}), 1, Vec3::Constant(0.5)), {0, 0, -1}, {0, 4, 0});
  const Body parting = moving(heavy(body(Sphere{1}, {0, 0, 1}), 1, Vec3::Constant(0.5)), {1, 0, 4}, {0, 0, 0});
  const Body falling = moving(heavy(body(cube, {2, 0, 1}), 1, {2, 3, 4}), {0, 0, -1}, {0, 0, 0});
  return {
      impact("a ball that skids", ball, ground, {0, 0, 0}, Law::poisson, 0.5, 0.125),
      impact("a ball that grips", ball, ground, {0, 0, 0}, Law::stronge, 0.5, 2),
      impact("a slow ball", slow_ball, ground, {0, 0, 0}, Law::poisson, 0.5, 0.25),
      impact("two balls", ball, other_ball, {0, 0, 0}, Law::poisson, 0.75, 0.25),
      impact("a rod whose slip stops", rod({-3, 0, -3}, 6, {3, 0, -5}), ground, {0, 0, 0}, Law::poisson, 1, 1),
      impact("a rod whose slip stops, by Newton's law", rod({-3, 0, -3}, 6, {3, 0, -5}), ground, {0, 0, 0}, Law::newton,
             1, 1),
      impact("a rod in Painlevé's range", rod({-3, 0, -6}, 15, {-100, 0, -1}), ground, {0, 0, 0}, Law::poisson, 0.5, 2),
      impact("boxes that meet off their centres", left, right, between, Law::poisson, 0.5, 0.5),
      impact("boxes that meet off their centres, by Stronge's law", turned_left, right, between, Law::stronge, 0.5,
             0.25),
      impact("boxes without friction", left, right, between, Law::poisson, 0.5, 0),
      impact("boxes that stay together", left, right, between, Law::newton, 0, 0.5),
      impact("boxes by Newton's law", left, right, between, Law::newton, 0.5, 0.125),
      impact("a box that sticks from the start", falling, ground, {0, 0, 0}, Law::poisson, 0.5, 4),
      impact("a ball that falls and stays", dropped, ground, {0, 0, 0}, Law::poisson, 0, 0.5),
      impact("a ball that falls, grips and rolls", spinning, ground, {0, 0, 0}, Law::poisson, 0, 2),
      impact("balls that part", parting, other_ball, {0, 0, 0}, Law::poisson, 0.5, 0.5),
      impact("an elastic ball without friction", dropped, ground, {0, 0, 0}, Law::poisson, 1, 0),
      impact("boxes that part", right, left, between, Law::poisson, 0.5, 0.5),
  };
}

Scene under(const Raster& raster, Scene scene) {
  scene.raster = raster;
  return scene;
}

std::vector<Scene> build() {
  return {
      pair("cubes apart along y", body(cube, {0, 0, 0}), body(cube, {0.5, 2.25, 0.25})),
      pair("cubes apart along y, the other way", body(cube, {0.5, 2.25, 0.25}), body(cube, {0, 0, 0})),
      pair("cubes 2^-32 apart", body(cube, {0, 0, 0}), body(cube, {0.5, 0.5, 2 + 0x1p-32})),
      pair("cubes that share a face", body(cube, {0, 0, 0}), body(cube, {0, 2, 0.5})),
      pair("vertex over a tilted face", body(brick, {0, 0, 0}, about_x), body(tetrahedron, {1, 0.5, 3}, skew)),
      pair("polytopes apart, far from the origin", body(wedge, {100, -50, 7}, skew),
           body(octahedron, {110, -45, 8}, about_y)),
      pair("edge over edge, overlapping", body(cube, {0, 0, 0}, about_x), body(cube, {0.25, 0.125, 2.75}, about_y)),
      pair("cubes overlapping along y", body(cube, {0, 0, 0}), body(cube, {0.25, 1.5, 0.5})),
      pair("polytopes deep in each other", body(octahedron, {0, 0, 0}, skew),
           body(tetrahedron, {-0.5, -0.25, -0.5}, about_y)),
      pair("polytopes overlapping, lopsided", body(wedge, {-3, -1, -1}), body(tetrahedron, {0.5, 0.25, 1}, skew)),
      pair("spheres apart", body(Sphere{1}, {1, 2, 3}), body(Sphere{0.5}, {3, 4, 4})),
      pair("spheres that touch", body(Sphere{1}, {0, 0, 0}), body(Sphere{2}, {1, 2, 2})),
      pair("sphere in a cube's side", body(Sphere{1}, {0.5, 0, 0}), body(cube, {0, 1.75, 0})),
      pair("sphere over a cube's corner", body(cube, {0, 0, 0}, skew), body(Sphere{0.25}, {3, 3, 3})),
      pair("two parts against one", body(corner(), {0, 0, 0}), body(octahedron, {-1, 3, 0.25}, about_y)),
      pair("the second part is nearer", body(corner(), {0, 0, 0}), body(cube, {4, 3, 0.25})),
      pair("a tetrahedron in a cube", body(tetrahedron, {-0.5, -0.75, -0.5}, about_x),
           body(Box{Vec3::Constant(8)}, {1, 0, 0}, about_y)),
      pair("two parts around a sphere", body(corner(), {0, 0, 0}, skew), body(Sphere{0.5}, {0, 0.25, 0})),
      many("boxes in a row, two of them touching",
           {body(cube, {0, 0, 0}), body(cube, {2, 0.5, 0}), body(cube, {5, 0, 0}, about_x), body(brick, {6, 2, 6}),
            body(octahedron, {2, 3, 0.5}, skew), body(Sphere{1}, {2, 1, 1})}),
      many("solids of several densities",
           {dense(body(tetrahedron, {1, 2, 3}, skew), 3), dense(body(wedge, {-4, 0, 0}, about_x), 0.5),
            unmoved(body(cube, {0, 0, 9}))}),
      sequence("boxes that come, touch, part and go", {cube, cube, brick},
               {{{0, at(0, 0, 0)}, {1, at(4, 0, 0)}},
                {{1, at(2, 0, 0)}, {2, at(0, 0, 1.5)}},
                {},
                {{0, at(-3, 0, 0)}, {1, at(2, 0, 0)}},
                {{0, {}}, {2, at(2, 0, 8)}},
                {{0, at(2, 2, 0)}, {2, at(2, 0, 1.5)}},
                {{1, {}}, {2, {}}}}),
      sequence("boxes in boxes that pass", {cube, Box{Vec3::Constant(4)}, Box{Vec3::Constant(0.25)}, Sphere{1}},
               {{{0, at(0, 0, 0)}, {1, at(9, 0, 1)}, {2, at(0, 0, -6)}, {3, at(0, 9, 0)}},
                {{1, at(1, 0, 0)}, {2, at(0, 0, 0)}, {3, at(0, -2, 0)}},
                {{1, at(-9, 0, 0)}, {2, at(0, 0, 6)}, {3, at(0, -1, 9)}},
                {{1, at(0, 0, -9)}, {0, at(0, 0, -9)}, {3, at(2, 0, -9)}}}),
      sequence("a row that one passes", {cube, cube, cube, cube},
               {{{0, at(0, 0, 0)}, {1, at(3, 0, 0)}, {2, at(6, 0, 0)}, {3, at(-4, 0, 0)}},
                {{3, at(-2, 0, 0)}},
                {{3, at(4.5, 0, 0)}},
                {{3, at(8, 0, 0)}, {0, at(0, 0, 0)}},
                {{3, at(8, 0, 2)}, {1, at(6, 0, 2)}}}),
      sequence("cubes that come within 2^-41 of each other", {cube, cube},
               {{{0, at(0, 0, 0)}, {1, at(4, 0, 0)}}, {{1, at(0.5, 0.5, 2 + 0x1p-41)}}, {{1, at(0, 5, 0)}}}),
      under({-2.5, -2.5, 1, 6, 6, 1, 0},
            pair("cubes with sides through centres, one on the other", body(cube, {0, 0, 0}), body(cube, {1, 0, 2}))),
      under({-3, -3, 0.5, 14, 12, 0, -1},
            pair("cubes apart, one above the other", body(cube, {0, 0, 0}), body(cube, {0.5, 0.25, 4}))),
      under({0, 0, 1, 66, 3, 3, 0}, pair("bars across a word's end", body(Box{Vec3(40, 1, 1)}, {30, 1, 0}),
                                         body(Box{Vec3(20, 2, 1)}, {40, 1, 0.5}))),
      under({-4, -4, 0.75, 12, 12, -2, 1}, pair("turned bodies under a raster", body(octahedron, {0, 0, 0}, skew),
                                                body(tetrahedron, {-1, -1, -0.5}, about_y))),
      under({-2, -2, 0.25, 20, 18, 0, 2}, pair("a ball in a corner, under a raster", body(Sphere{1}, {1, 2, 0.5}),
                                               body(corner(), {0, 0, 0}, about_x))),
      under({-2.25, -2.25, 0.5, 9, 9, 0, 0},
            pair("diamonds, one on the other", body(octahedron, {0, 0, 0}), body(octahedron, {0, 0, 2}))),
      many("a needle", {dense(body(needle, {1, 2, 3}, about_x), 2)}),
      pair("cubes 2^-41 apart", body(cube, {0, 0, 0}), body(cube, {0.5, 0.5, 2 + 0x1p-41})),
      pair("an edge that rises by 2^-41 over a cube", body(nearly_level, {0, 0, 2}), body(cube, {0, 0, 0})),
  };
}

}  // namespace

Body body(Shape shape, const Vec3& p_WB, const Quaternion& q_WB) {
  Body made;
  made.shape = std::move(shape);
  made.X_WB = {p_WB, q_WB};
  return made;
}

Scene pair(const std::string& name, Body a, Body b) { return many(name, {std::move(a), std::move(b)}); }

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = build();
  return all;
}

const std::vector<Scene>& impacts() {
  static const std::vector<Scene> all = build_impacts();
  return all;
}

const std::vector<Scene>& scenes_of(const std::string& query) {
  if (query == "impulse") return impacts();
  if (query == "constraint") return tables();
  if (query == "time_of_impact") return motion_scenes();
  return query == "simulation" ? runs() : scenes();
}

const Scene& scene(const std::string& name) {
  for (const auto* some : {&scenes(), &impacts(), &motion_scenes(), &runs(), &tables()}) {
    const auto found = std::ranges::find(*some, name, &Scene::name);
    if (found != some->end()) return *found;
  }
  throw std::out_of_range(name);
}

}  // namespace touchstone::tests
