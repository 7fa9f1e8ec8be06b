// Each adapter on scenes with obvious answers: units, frames, half extents, the direction of a normal. A mistake here
// would blame an engine unjustly. Engines' errors are for the properties to detect, so the bound is a loose 1e-5.
#include <limits>

#include "oracle/process/pipe.h"
#include "tests/catch.h"
#include "tests/oracle/built_subjects.h"

namespace touchstone::oracle {
namespace {

const Quaternion upright{1, 0, 0, 0};
const Quaternion quarter_turn_about_x{3, 3, 0, 0};  ///< y to z, z to -y; not of unit length
const Polytope tetrahedron{{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
const Polytope cube{
    {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

Body body(Shape shape, const Vec3& p_WB, const Quaternion& q_WB = upright) {
  Body made;
  made.shape = std::move(shape);
  made.X_WB = {p_WB, q_WB};
  return made;
}

Scene pair(Body A, Body B) {
  Scene scene;
  scene.bodies = {std::move(A), std::move(B)};
  return scene;
}

Scene swapped(Scene scene) {
  std::swap(scene.bodies[0], scene.bodies[1]);
  return scene;
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-5; }
bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() <= 1e-5; }

template <class T>
T said(const Answer<T>& answer) {
  REQUIRE(std::holds_alternative<T>(answer));
  return std::get<T>(answer);
}

/// Checks only the verdict of engines that report no distance.
void expect_distance(const Scene& scene, double distance, const Vec3& from_B_to_A) {
  for (const auto& subject : answering("distance")) {
    CAPTURE(subject->card().name);
    const Distance d = said(subject->distance(scene));
    CHECK(d.verdict == Verdict::separated);
    if (!d.distance) continue;
    CHECK(near(*d.distance, distance));
    CHECK(near(*d.p_WCa - *d.p_WCb, from_B_to_A));
  }
}

void expect_depth(const Scene& scene, double depth, const Vec3& nhat_BA_W, const std::string& passed_over = "") {
  for (const auto& subject : answering("penetration")) {
    CAPTURE(subject->card().name);
    if (subject->card().name == passed_over) continue;
    const Penetration p = said(subject->penetration(scene));
    CHECK(p.verdict == Verdict::overlapping);
    CHECK(near(p.depth.value(), depth));
    CHECK(near(p.nhat_BA_W.value(), nhat_BA_W));
  }
}

TEST_CASE("boxes apart: half extents, not sides") {
  const Scene scene = pair(body(Box{{1, 2, 3}}, {5, 1, 2}), body(Box{{2, 2, 2}}, {0, 0, 0}));
  expect_distance(scene, 2, {2, 0, 0});
  expect_distance(swapped(scene), 2, {-2, 0, 0});
}

TEST_CASE("spheres apart, far from the origin") {
  expect_distance(pair(body(Sphere{1}, {13, 24, 5}), body(Sphere{2}, {10, 20, 5})), 2, {1.2, 1.6, 0});
}

TEST_CASE("a turned tetrahedron under a box: q and 3q are one rotation, and which way it turns") {
  const Scene scene =
      pair(body(Box{{0.5, 0.5, 0.5}}, {0.25, 0.25, 3}), body(tetrahedron, {0, 0, 0}, quarter_turn_about_x));
  expect_distance(scene, 0.5, {0, 0, 0.5});
}

TEST_CASE("witness points are in the world") {
  const Scene scene = pair(body(Sphere{1}, {10, 20, 35}), body(Box{{2, 3, 1}}, {10, 20, 30}, quarter_turn_about_x));
  for (const auto& subject : answering("distance")) {
    CAPTURE(subject->card().name);
    const Distance d = said(subject->distance(scene));
    if (!d.distance) continue;
    CHECK(near(*d.distance, 1));
    CHECK(near(*d.p_WCa, {10, 20, 34}));
    CHECK(near(*d.p_WCb, {10, 20, 33}));
  }
}

TEST_CASE("boxes in each other: the normal points from B to A, in the world") {
  const Scene scene = pair(body(Box{{1, 1, 1}}, {0.25, 0.5, 1.75}), body(Box{{1, 1, 1}}, {0, 0, 0}));
  expect_depth(scene, 0.25, {0, 0, 1});
  expect_depth(swapped(scene), 0.25, {0, 0, -1});
  const Scene turned = pair(body(Box{{1, 2, 3}}, {10.25, 0.25, 7.5}, quarter_turn_about_x),
                            body(Box{{1, 2, 3}}, {10, 6, 7}, quarter_turn_about_x));
  expect_depth(turned, 0.25, {0, -1, 0});
}

TEST_CASE("hulls in each other") {
  const Scene scene =
      pair(body(cube, {10.25, 4.25, 7.5}, quarter_turn_about_x), body(cube, {10, 6, 7}, quarter_turn_about_x));
  expect_depth(scene, 0.25, {0, -1, 0}, "fcl.indep");
  expect_depth(swapped(scene), 0.25, {0, 1, 0}, "fcl.indep");
}

/// FCL's contact depth should be positive "when in collision", and its normal in the world frame; fcl::distance itself
/// aborts on the depth that this solver returns (FCL issue 541). An adapter that corrected the sign would hide that.
TEST_CASE("FCL's own solver negates the depth of hulls and leaves their normal in A's frame, and its adapter says so") {
  const Scene scene =
      pair(body(cube, {10.25, 4.25, 7.5}, quarter_turn_about_x), body(cube, {10, 6, 7}, quarter_turn_about_x));
  for (const auto& subject : answering("penetration")) {
    if (subject->card().name != "fcl.indep") continue;
    const Penetration p = said(subject->penetration(scene));
    CHECK(near(p.depth.value(), -0.25));
    CHECK(near(p.nhat_BA_W.value(), {0, 0, 1}));
  }
}

TEST_CASE("spheres in each other") {
  const Scene scene = pair(body(Sphere{1}, {1, 5, 1}), body(Sphere{1.5}, {1, 3, 1}));
  for (const auto& subject : answering("penetration")) {
    CAPTURE(subject->card().name);
    const Penetration p = said(subject->penetration(scene));
    CHECK(p.verdict == Verdict::overlapping);
    // EPA approximates a sphere by facets: its default tolerance shows.
    CHECK(std::abs(p.depth.value() - 0.5) < 0.01);
    CHECK((p.nhat_BA_W.value() - Vec3(0, 1, 0)).norm() < 0.1);
  }
}

TEST_CASE("bounds of a sphere, a turned box and a turned tetrahedron") {
  Scene scene = pair(body(Sphere{2}, {1, 2, 3}), body(Box{{1, 2, 3}}, {10, 0, 0}, quarter_turn_about_x));
  scene.bodies.push_back(body(tetrahedron, {0, 10, 0}, quarter_turn_about_x));
  for (const auto& subject : answering("bounds")) {
    CAPTURE(subject->card().name);
    const Bounds bounds = said(subject->bounds(scene));
    REQUIRE(bounds.size() == 3);
    CHECK(near(bounds[0].lo, {-1, 0, 1}));
    CHECK(near(bounds[0].hi, {3, 4, 5}));
    CHECK(near(bounds[1].lo, {9, -3, -2}));
    CHECK(near(bounds[1].hi, {11, 3, 2}));
    CHECK(near(bounds[2].lo, {0, 9, 0}));
    CHECK(near(bounds[2].hi, {4, 10, 2}));
  }
}

/// FCL's managers that err after a removal even on scenes as simple as these, also without our adapter
/// (docs/design/broad_phase.md).
bool errs_after_removal(const Subject& subject) {
  const std::string& name = subject.card().name;
  return name == "fcl.sap" || name == "fcl.interval_tree";
}

/// The collider's box of a box is that of the ball about it.
bool has_least_boxes(const Subject& subject) { return subject.card().name != "fast.warm"; }

TEST_CASE("broad phase of a row of boxes, and of balls") {
  for (const Shape& shape : {Shape(Box{{1, 1, 1}}), Shape(Sphere{1})}) {
    Scene scene;
    for (const double x : {4.5, 0.0, 1.5, 3.0, 20.0}) scene.bodies.push_back(body(shape, {x, 0, 0}));
    for (const auto& subject : answering("broad_phase")) {
      CAPTURE(subject->card().name);
      if (std::holds_alternative<Box>(shape) && !has_least_boxes(*subject)) continue;
      CHECK(said(subject->broad_phase(scene)) == PairSet{{0, 3}, {1, 2}, {2, 3}});
    }
  }
}

/// The bodies are added one after the other, one passes between two others, and one is removed.
TEST_CASE("a film of boxes, and of balls: who comes, moves and goes") {
  const auto at = [](double x) { return Pose{{x, 0.25, 0.5}, {}}; };
  for (const Shape& shape : {Shape(Box{{1, 1, 1}}), Shape(Sphere{1})}) {
    Scene sequence;
    for (int i = 0; i < 3; ++i) sequence.bodies.push_back(body(shape, {0, 0, 0}));
    sequence.frames = {{{1, at(0)}}, {{0, at(9)}}, {{0, at(1.5)}, {2, at(3)}}, {}, {{1, {}}}, {{1, at(4.5)}}};
    for (const auto& subject : answering("pair_history")) {
      CAPTURE(subject->card().name);
      if (errs_after_removal(*subject) || (std::holds_alternative<Box>(shape) && !has_least_boxes(*subject))) continue;
      const PairHistory history = said(subject->pair_history(sequence));
      REQUIRE(history.size() == 6);
      CHECK(history[0].pairs.empty());
      CHECK(history[1].pairs.empty());
      CHECK(history[2].pairs == PairSet{{0, 1}, {0, 2}});
      CHECK(history[3].pairs == PairSet{{0, 1}, {0, 2}});
      CHECK(history[4].pairs == PairSet{{0, 2}});
      CHECK(history[5].pairs == PairSet{{0, 2}, {1, 2}});
      if (history[4].ended) CHECK(history[4].ended == PairSet{{0, 1}});
    }
  }
}

TEST_CASE("mass of a dense box, of a sphere, and what is given or fixed") {
  Scene scene = pair(body(Box{{1, 2, 3}}, {7, 0, 0}), body(Sphere{2}, {0, 0, 0}));
  scene.bodies[0].mass = Density{0.5};
  scene.bodies.push_back(body(cube, {0, 0, 0}));
  scene.bodies.back().mass = MassProperties{3, {1, 2, 3}, 4 * Mat3::Identity()};
  scene.bodies.push_back(body(cube, {0, 0, 0}));
  scene.bodies.back().mass = Fixed{};
  for (const auto& subject : answering("mass")) {
    CAPTURE(subject->card().name);
    const Masses masses = said(subject->mass(scene));
    REQUIRE(masses.size() == 4);
    CHECK(near(masses[0]->mass, 24));
    CHECK(near(Vec3(masses[0]->I_BBcm_B.diagonal()), {104, 80, 40}));
    CHECK(std::abs(masses[1]->mass - 33.5103216) < 1e-4);
    CHECK(std::abs(masses[1]->I_BBcm_B(2, 2) - 53.6165146) < 1e-4);
    CHECK(masses[2] == std::get<MassProperties>(scene.bodies[2].mass));
    CHECK(!masses[3]);
  }
}

TEST_CASE("mass of a hull") {
  Scene scene = pair(body(tetrahedron, {7, 0, 0}), body(Sphere{2}, {0, 0, 0}));
  scene.bodies[0].mass = Density{3};
  for (const auto& subject : answering("mass")) {
    CAPTURE(subject->card().name);
    const Answer<Masses> answer = subject->mass(scene);
    if (std::holds_alternative<Abstains>(answer)) continue;
    CHECK(near(said(answer)[0]->mass, 4));
    CHECK(near(said(answer)[0]->p_BBcm, {1, 0.5, 0.25}));
  }
}

TEST_CASE("the reference abstains where no double holds the exact value") {
  const double far = std::numeric_limits<double>::max();
  const auto reference = connect("reference", TOUCHSTONE_SUBJECTS);
  const Scene far_out = pair(body(Sphere{far}, {far, 0, 0}), body(Box{Vec3::Constant(1e-150)}, {0, 0, 0}));
  CHECK(std::holds_alternative<Abstains>(reference->bounds(far_out)));
  CHECK(std::holds_alternative<Abstains>(reference->mass(far_out)));
  const Scene speck = pair(body(Box{Vec3::Constant(1e-150)}, {0, 0, 0}), body(Box{{1, 1, 1}}, {9, 0, 0}));
  CHECK(std::holds_alternative<Abstains>(reference->mass(speck)));  // it would be rounded to 0
  CHECK(std::holds_alternative<Bounds>(reference->bounds(speck)));
}

/// B's motion began earlier, and no doubles hold its position at the start, where the boxes touch: no bound of the
/// distance is known. JSON has no word for infinity.
TEST_CASE("the reference tells no gap that it does not know") {
  Scene scene = pair(body(Box{{3, 3, 2}}, {0, -1, -1}, {1, 1, 1, 1}), body(Box{{2, 1, 2}}, {0, 0, 0}, {1, 1, 1, 1}));
  scene.bodies[1].X_WB.p_WB.x() = 0x1p-60;
  scene.bodies[1].velocity.v_WBcm = {1, -6, 0};
  scene.motion = Motion{};
  scene.motion->sample_times = {2};
  scene.motion->start_times = {1, 0};
  const auto reference = connect("reference", TOUCHSTONE_SUBJECTS);
  const TimeOfImpact answer = said(reference->time_of_impact(scene));
  CHECK(answer.status == TimeOfImpact::Status::undecided);
  CHECK(!answer.gap);
}

/// A ball of mass 1 and inertia 1/2 that hits a body at the origin from above.
Scene impact(const Vec3& v, Body other, double e, double mu) {
  Body ball = body(Sphere{1}, {0, 0, 1});
  MassProperties given;
  given.mass = 1;
  given.I_BBcm_B = Vec3(0.5, 0.5, 0.5).asDiagonal();
  ball.mass = given;
  ball.velocity.v_WBcm = v;
  Scene scene = pair(ball, std::move(other));
  scene.contact = Contact{{0, 0, 0}, {0, 0, 1}, Law::newton, e, mu};
  return scene;
}

/// By each law of restitution that the subject supports; in these scenes all three agree.
void expect_impulse(const Scene& scene, const std::array<Velocity, 2>& after) {
  for (const auto& subject : answering("impulse")) {
    CAPTURE(subject->card().name);
    int laws = 0;
    for (const Law law : {Law::poisson, Law::stronge, Law::newton}) {
      Scene one = scene;
      one.contact->law = law;
      const Answer<Impulse> answer = subject->impulse(one);
      if (std::holds_alternative<Abstains>(answer)) continue;
      ++laws;
      const Impulse first = said(answer);
      Scene other = swapped(one);
      other.contact->nhat_BA_W = -other.contact->nhat_BA_W;
      const Impulse second = said(subject->impulse(other));
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK(near(first.after[i].v_WBcm, after[i].v_WBcm));
        CHECK(near(first.after[i].w_WB, after[i].w_WB));
        CHECK(near(second.after[1 - i].v_WBcm, after[i].v_WBcm));
        CHECK(near(second.after[1 - i].w_WB, after[i].w_WB));
      }
    }
    CHECK(laws > 0);
  }
}

TEST_CASE("oracle: impulse: head on, two balls part at e times their approach") {
  Body other = body(Sphere{1}, {0, 0, -1});
  MassProperties heavy;
  heavy.mass = 3;
  heavy.I_BBcm_B = Mat3::Identity();
  other.mass = heavy;
  expect_impulse(impact({0, 0, -2}, other, 0.5, 0.25), {Velocity{{0, 0, 0.25}, {0, 0, 0}}, {{0, 0, -0.75}, {0, 0, 0}}});
  expect_impulse(impact({0, 0, -2}, other, 1, 0), {Velocity{{0, 0, 1}, {0, 0, 0}}, {{0, 0, -1}, {0, 0, 0}}});
}

// P_n = 3. Friction mu P_n = 3/4 acts against the slip; stopping it would take 1, as K_t = 1 + 1/(1/2).
TEST_CASE("oracle: impulse: friction is mu times the impulse, its moment spins the ball") {
  Body ground = body(Box{{4, 4, 1}}, {0, 0, -1});
  ground.mass = Fixed{};
  const Velocity still{};
  expect_impulse(impact({3, 0, -2}, ground, 0.5, 0.25), {Velocity{{2.25, 0, 1}, {0, 1.5, 0}}, still});
  expect_impulse(impact({0, -3, -2}, ground, 0.5, 0.25), {Velocity{{0, -2.25, 1}, {1.5, 0, 0}}, still});
  expect_impulse(impact({3, 0, -2}, ground, 0.5, 2), {Velocity{{2, 0, 1}, {0, 2, 0}}, still});
}

TEST_CASE("oracle: impulse: masses by density, centres of mass off the origin") {
  Body ground = body(Box{{4, 4, 1}}, {0, 0, -1});
  ground.mass = Fixed{};
  Scene scene = impact({0, 0, -2}, ground, 1, 0);
  scene.bodies[0].mass = Density{2};
  expect_impulse(scene, {Velocity{{0, 0, 2}, {0, 0, 0}}, {}});
  // m = 1, I = 1/2, and C is 1 to the left of the centre of mass: K_nn = 1 + 1/(1/2), P_n = 4/3; the moment is about
  // +y.
  scene.bodies[0] = impact({0, 0, -2}, ground, 1, 0).bodies[0];
  std::get<MassProperties>(scene.bodies[0].mass).p_BBcm = {1, 0, 0};
  expect_impulse(scene, {Velocity{{0, 0, -2 + 4.0 / 3}, {0, 8.0 / 3, 0}}, {}});
}

// The two do not approach, so nothing changes. In a step of 2⁻¹⁰⁰ s the body would turn by 0.02 rad.
TEST_CASE("oracle: impulse: Simbody's step turns no body, however fast it spins") {
  Body spinning = body(Box{{1, 2, 1}}, {0, 0, 0});
  spinning.velocity.w_WB = {0, 0x1p94, 0x1p93};
  Body fixed = body(Sphere{1}, {0, 0, 0});
  fixed.mass = Fixed{};
  Scene scene = pair(spinning, fixed);
  scene.contact = Contact{{0, 0, 0}, {0, 0, 1}, Law::poisson, 0, 0};
  for (const auto& subject : answering("impulse")) {
    CAPTURE(subject->card().name);
    if (subject->card().name != "simbody.poisson") continue;
    const Vec3 change = said(subject->impulse(scene)).after[0].w_WB - spinning.velocity.w_WB;
    CHECK(change.norm() <= 0x1p-50 * spinning.velocity.w_WB.norm());
  }
}

TEST_CASE("a subject in Python") {
  const auto subject =
      connect("exec:/usr/bin/python3 '" TOUCHSTONE_SOURCE "/oracle/subjects/python/sphere_engine.py'", "");
  const Distance spheres = said(subject->distance(pair(body(Sphere{1}, {13, 24, 5}), body(Sphere{2}, {10, 20, 5}))));
  CHECK(near(spheres.distance.value(), 2));
  CHECK(near(*spheres.p_WCa - *spheres.p_WCb, {1.2, 1.6, 0}));
  const Scene scene = pair(body(Sphere{1}, {10, 20, 35}), body(Box{{2, 3, 1}}, {10, 20, 30}, quarter_turn_about_x));
  const Distance sphere_and_box = said(subject->distance(scene));
  CHECK(near(sphere_and_box.distance.value(), 1));
  CHECK(near(sphere_and_box.p_WCb.value(), {10, 20, 33}));
  CHECK(said(subject->distance(swapped(scene))).p_WCa == sphere_and_box.p_WCb);
  CHECK(std::holds_alternative<Abstains>(subject->distance(pair(body(cube, {9, 0, 0}), body(cube, {0, 0, 0})))));
  CHECK(std::holds_alternative<Abstains>(subject->mass(scene)));
}

}  // namespace
}  // namespace touchstone::oracle
