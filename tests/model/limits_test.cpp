// Values that JSON cannot represent (NaN, Inf), and values at the limits; bad_scenes.json has the rest.
#include "model/limits.h"

#include <limits>

#include "model/input_error.h"
#include "tests/catch.h"

namespace touchstone {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double denormal = 5e-324;

Scene tetrahedron() {
  Scene scene;
  scene.bodies.emplace_back();
  scene.bodies[0].shape = Polytope{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, {}};
  return scene;
}

/// `spoil` changes the only body.
template <class Spoil>
std::string complaint(Spoil spoil) {
  Scene scene = tetrahedron();
  spoil(scene.bodies[0]);
  try {
    validate(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST_CASE("numbers that are not finite are refused by place") {
  CHECK(complaint([](Body& b) { std::get<Polytope>(b.shape).vertices[2][1] = nan; }) ==
        "bodies[0].shape.vertices[2][1]: NaN; expected a finite number");
  CHECK(complaint([](Body& b) { b.shape = Sphere{inf}; }) ==
        "bodies[0].shape.radius: infinite; expected a finite number");
  CHECK(complaint([](Body& b) { b.shape = Box{Vec3(1, nan, 1)}; }) ==
        "bodies[0].shape.half_extents[1]: NaN; expected a finite number");
  CHECK(complaint([](Body& b) { b.X_WB.p_WB[0] = -inf; }) == "bodies[0].X_WB.p[0]: infinite; expected a finite number");
  CHECK(complaint([](Body& b) { b.X_WB.q_WB.z = nan; }) == "bodies[0].X_WB.q.z: NaN; expected a finite number");
  CHECK(complaint([](Body& b) { b.velocity.v_WBcm[0] = nan; }) ==
        "bodies[0].velocity.v_WBcm[0]: NaN; expected a finite number");
  CHECK(complaint([](Body& b) { b.velocity.w_WB[2] = inf; }) ==
        "bodies[0].velocity.w_WB[2]: infinite; expected a finite number");
  CHECK(complaint([](Body& b) { b.material.restitution = nan; }) ==
        "bodies[0].material.restitution: NaN; expected a finite number");
  CHECK(complaint([](Body& b) { b.material.friction = inf; }) ==
        "bodies[0].material.friction: infinite; expected a finite number");
  CHECK(complaint([](Body& b) { b.mass = Density{nan}; }) == "bodies[0].mass.density: NaN; expected a finite number");
  CHECK(complaint([](Body& b) {
          b.mass = MassProperties{inf, Vec3::Zero(), Mat3::Identity()};
        }) == "bodies[0].mass.mass: infinite; expected a finite number");
  CHECK(complaint([](Body& b) {
          b.mass = MassProperties{1, Vec3(0, 0, nan), Mat3::Identity()};
        }) == "bodies[0].mass.p_BBcm[2]: NaN; expected a finite number");
  CHECK(complaint([](Body& b) {
          b.mass = MassProperties{1, Vec3::Zero(), Mat3::Constant(nan)};
        }) == "bodies[0].mass.I_BBcm_B[0][0]: NaN; expected a finite number");
  Scene scene = tetrahedron();
  scene.gravity[1] = nan;
  CHECK_THROWS_WITH(validate(scene), "gravity[1]: NaN; expected a finite number");
}

TEST_CASE("what is small or large, but finite, is legal") {
  const double greatest = std::numeric_limits<double>::max();
  CHECK(complaint([](Body&) {}) == "accepted");
  CHECK(complaint([](Body& b) { b.X_WB.q_WB = {0, 0, 0, -denormal}; }) == "accepted");
  CHECK(complaint([&](Body& b) { b.X_WB.q_WB = {greatest, greatest, greatest, greatest}; }) == "accepted");
  CHECK(complaint([](Body& b) { b.shape = Sphere{denormal}; }) == "accepted");
  CHECK(complaint([](Body& b) { std::get<Polytope>(b.shape).vertices[0][0] = denormal; }) == "accepted");
  CHECK(complaint([](Body& b) {
          b.mass = MassProperties{denormal, Vec3::Zero(), Mat3::Identity() * denormal};
        }) == "accepted");
  CHECK(complaint([&](Body& b) {
          b.mass = MassProperties{1, Vec3::Zero(), Mat3::Identity() * greatest};
        }) == "accepted");
  CHECK(complaint([](Body& b) { b.material = {1, 1e300}; }) == "accepted");
  CHECK_NOTHROW(validate(Scene{}));
}

TEST_CASE("the zero quaternion is refused, whatever its signs") {
  CHECK(complaint([](Body& b) {
          b.X_WB.q_WB = {0, -0.0, 0, -0.0};
        }) == "bodies[0].X_WB.q: zero; expected a quaternion with a non-zero component");
}

TEST_CASE("an impossible inertia is refused at any scale") {
  for (const double scale : {1e-300, 1e-20, 1.0, 1e20, 1e300}) {
    Mat3 I = Mat3::Zero();
    I.diagonal() = Vec3(1, 2, 4) * scale;
    CHECK(complaint([&](Body& b) {
            b.mass = MassProperties{1, Vec3::Zero(), I};
          }) ==
          "bodies[0].mass.I_BBcm_B: no solid has it: the greatest principal moment exceeds the sum of the other two");
  }
}

TEST_CASE("a thin plate's inertia is a limit case and legal, turned or not") {
  Mat3 plate = Mat3::Zero();
  plate.diagonal() = Vec3(1, 2, 3);
  CHECK(complaint([&](Body& b) { b.mass = MassProperties{1, Vec3::Zero(), plate}; }) == "accepted");
  Mat3 R;
  R << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  const Mat3 turned = R * plate * R.transpose() / 9;
  CHECK(complaint([&](Body& b) {
          b.mass = MassProperties{1, Vec3::Zero(), (turned + turned.transpose()) / 2};
        }) == "accepted");
  plate(2, 2) = 3 + 1e-9;
  CHECK(complaint([&](Body& b) { b.mass = MassProperties{1, Vec3::Zero(), plate}; }) != "accepted");
}

/// `spoil` changes the contact of two balls.
template <class Spoil>
std::string impact_complaint(Spoil spoil) {
  Scene scene;
  for (int i = 0; i < 2; ++i) scene.bodies.emplace_back().shape = Sphere{1};
  scene.contact = Contact{};
  spoil(scene);
  try {
    validate(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST_CASE("an impact that has no meaning is refused by place") {
  CHECK(impact_complaint([](Scene&) {}) == "accepted");
  CHECK(impact_complaint([](Scene& s) { s.contact->friction = inf; }) == "accepted");
  CHECK(impact_complaint([](Scene& s) { s.contact->nhat_BA_W = Vec3(1, 2, 3).normalized(); }) == "accepted");
  CHECK(impact_complaint([](Scene& s) { s.contact->nhat_BA_W = Vec3(0, 0, 0); }) ==
        "contact.nhat_BA_W: zero; expected a direction of length 1");
  CHECK(impact_complaint([](Scene& s) { s.contact->nhat_BA_W = Vec3(0, 0, 2); }) ==
        "contact.nhat_BA_W: expected a direction of length 1 within rounding, found 2");
  CHECK(impact_complaint([](Scene& s) { s.contact->nhat_BA_W = Vec3(0, nan, 1); }) ==
        "contact.nhat_BA_W[1]: NaN; expected a finite number");
  CHECK(impact_complaint([](Scene& s) { s.contact->p_WC[2] = nan; }) ==
        "contact.p_WC[2]: NaN; expected a finite number");
  CHECK(impact_complaint([](Scene& s) { s.contact->restitution = 1.5; }) ==
        "contact.restitution: expected a number from 0 to 1, found 1.5");
  CHECK(impact_complaint([](Scene& s) { s.contact->restitution = nan; }) ==
        "contact.restitution: NaN; expected a finite number");
  CHECK(impact_complaint([](Scene& s) { s.contact->friction = -1; }) ==
        "contact.friction: expected a number that is not negative, found -1");
  CHECK(impact_complaint([](Scene& s) { s.contact->friction = nan; }) == "contact.friction: NaN; expected a number");
  CHECK(impact_complaint([](Scene& s) { s.bodies[0].mass = s.bodies[1].mass = Fixed{}; }) ==
        "contact: both bodies are fixed; expected one that an impulse moves");
  CHECK(impact_complaint([](Scene& s) { s.bodies.pop_back(); }) == "contact: expected two bodies, found 1");
}

}  // namespace
}  // namespace touchstone
