#include "fast/motion/ballistic_motion.h"

#include <array>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/sine.h"
#include "reference/ballistic_motion.h"
#include "reference/validity.h"
#include "tests/catch.h"
#include "tests/fast/motion/random_motion.h"

namespace touchstone::fast::motion {
namespace {

using tests::RandomMotion;

double beyond(double x, const Interval& truth) { return std::max({0.0, truth.lo - x, x - truth.hi}); }

/// Errors of the kinematics against the truth (m, for points at one metre), and the claimed error bounds.
struct Compared {
  double off = 0, claimed = 0, w_off = 0, w_claimed = 0;
};

Compared compare(const Scene& scene, double t) {
  const RigidBodyModel model(scene.bodies[0]);
  const Vec3 a = model.is_fixed ? Vec3(Vec3::Zero()) : scene.gravity;
  const BallisticMotion motion(model, 0, scene.bodies[0].X_WB, scene.bodies[0].velocity, a);
  const Kinematics now = motion.kinematics(t);
  const reference::BallisticTruth truth = reference::ballistic_state(scene, 0, t);
  Compared c;
  Mat3 R_off;
  Vec3 p_off, w_off;
  const Vec3 p_WB = now.centre.p_WOBcm - now.R_WB * model.p_BBcm;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto e = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < 3; ++j) {
      R_off(e, static_cast<Eigen::Index>(j)) = beyond(now.R_WB(e, static_cast<Eigen::Index>(j)), truth.R_WB[i][j]);
    }
    p_off[e] = beyond(p_WB[e], truth.p_WB[i]);
    w_off[e] = beyond(now.w_WB[e], truth.w_WB[i]);
  }
  c.off = R_off.norm() + p_off.norm();
  c.claimed = now.turn_error * (1 + model.p_BBcm.norm()) + now.centre.error;
  c.w_off = w_off.norm();
  c.w_claimed = now.w_error;
  return c;
}

TEST_CASE("sine and cosine are as near as they say") {
  tests::Bits bits(1);
  for (int i = 0; i < 20'000; ++i) {
    const double x = std::ldexp(static_cast<double>(bits.next() >> 11), -53 + bits.below(48));
    const SineCosine found = sine_cosine(x);
    const double allowed = (4 + 2 * x) * u;  // one u for the library's own error
    REQUIRE(std::abs(found.sine - std::sin(x)) <= allowed);
    REQUIRE(std::abs(found.cosine - std::cos(x)) <= allowed);
  }
}

TEST_CASE("flights stand where the reference says, within what they claim") {
  RandomMotion random(2);
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = reference::completed(random.alone(i % 6));
    for (const double t : {0.0, 0.03125, 0.5, 1.0}) {
      const Compared c = compare(scene, t);
      CAPTURE(i, t, c.off, c.claimed, c.w_off, c.w_claimed);
      REQUIRE(c.off <= c.claimed);
      REQUIRE(c.w_off <= c.w_claimed + 0x1p-1000);
      if (i % 6 < 4) worst = std::max(worst, c.claimed);
    }
  }
  CHECK(worst < 1e-11);
}

// Its own axis hardly turns it: the error of that axis must not count as if it were far from round.
TEST_CASE("a body that is nearly round is known as well as one that turns steadily") {
  Scene scene;
  scene.bodies.resize(1);
  scene.motion.emplace();
  Body& body = scene.bodies[0];
  body.shape = Box{{1, 1, 1}};
  body.velocity.w_WB = {3, -1, 2};
  const double w = body.velocity.w_WB.norm();
  for (const double more : {0x1p-20, 1.0}) {
    const Vec3 moments(1, 1, 1 + more);
    body.mass = MassProperties{1, Vec3::Zero(), moments.asDiagonal()};
    for (const double t : {1.0, 32.0, 256.0}) {
      scene.motion->sample_times = {t};
      const Compared found = compare(scene, t);
      CHECK(found.off <= found.claimed);
      CHECK(found.w_off <= found.w_claimed);
      if (more < 1) CHECK(found.claimed <= (160 + 20 * w * t) * u);
    }
  }
}

// Its moments are sums that round; but they are compared exactly, so ω is known to be constant.
TEST_CASE("a polytope with equal moments and a density is known as well as one that turns steadily") {
  Scene scene;
  scene.bodies.resize(1);
  scene.motion.emplace();
  Body& body = scene.bodies[0];
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  body.shape = Polytope{{x, -x, y, -y, z, -z}, {}};
  body.velocity.w_WB = {3, -1, 2};
  const double w = body.velocity.w_WB.norm();
  for (const double t : {1.0, 32.0}) {
    scene.motion->sample_times = {t};
    const Compared found = compare(reference::completed(scene), t);
    CHECK(found.off <= found.claimed);
    CHECK(found.w_off <= found.w_claimed);
    CHECK(found.claimed <= (160 + 20 * w * t) * u);
  }
}

TEST_CASE("tumbling bodies stay where the reference says for 10,000 radians, within what they claim") {
  RandomMotion random(5);
  double worst = 0, worst_off = 0;
  for (int i = 0; i < 24; ++i) {
    Scene scene = random.alone(std::array{1, 3, 4, 5}[static_cast<std::size_t>(i % 4)]);
    scene.gravity.setZero();
    scene.bodies[0].velocity.v_WBcm.setZero();
    scene.motion->sample_times = {2048};
    scene = reference::completed(scene);
    for (const double t : {10.0, 128.5, 2048.0}) {
      const Compared c = compare(scene, t);
      CAPTURE(i, t, c.off, c.claimed, c.w_off, c.w_claimed);
      REQUIRE(c.off <= c.claimed);
      REQUIRE(c.w_off <= c.w_claimed);
      worst = std::max(worst, c.claimed);
      worst_off = std::max(worst_off, c.off);
    }
  }
  CAPTURE(1e15 * worst, 1e15 * worst_off);
  CHECK(worst < 1e-6);
  CHECK(worst_off < 1e-10);
}

/// A box with sides 3 : 2 : 1, spun nearly about its middle axis.
Scene spun(const Vec3& w) {
  RandomMotion random(1);
  Scene scene = random.alone(1);
  scene.bodies[0].shape = Box{Vec3(0.375, 0.25, 0.125)};
  scene.bodies[0].X_WB = {};
  scene.bodies[0].velocity = {Vec3::Zero(), w};
  scene.gravity.setZero();
  return reference::completed(scene);
}

// The moments of a compound with a density are known to some hundred ulps, which takes time to matter.
TEST_CASE("soon after its start a tumbling body is known almost as well as at its start") {
  Scene scene = RandomMotion(3).alone(4);
  Body& body = scene.bodies[0];
  body.shape =
      Compound{{{{{2, 0, 0}, {1, 0, 0, 0}}, std::get<Polytope>(body.shape)}, {{{0, 0, -1}, {0, 0, 0, -2}}, Sphere{1}}}};
  body.velocity.w_WB = {0.1, -1, 0.2};
  for (const double t : {0x1p-40, 0x1p-10, 0x1p-6, 0x1p-4, 0.25, 1.0}) {
    const Compared c = compare(scene, t);
    CAPTURE(t, c.off, c.claimed, c.w_off, c.w_claimed);
    CHECK(c.off <= c.claimed);
    CHECK(c.w_off <= c.w_claimed);
    if (t < 0.05) CHECK(c.claimed < 2e-13);
  }
}

TEST_CASE("a body at 10,000 rad/s that turns over and over is followed for a second") {
  const Compared c = compare(spun(Vec3(16, 1e4, 16)), 1);
  CAPTURE(1e15 * c.off, 1e15 * c.claimed, c.w_off, c.w_claimed);
  CHECK(c.off <= c.claimed);
  CHECK(c.w_off <= c.w_claimed);
  CHECK(c.claimed < 2e-4);
  CHECK(c.off < 1e-10);
}

TEST_CASE("a body about its middle axis stays there, where nothing rounds") {
  for (const Quaternion& q : {Quaternion{}, Quaternion{0, 3, 0, 0}, Quaternion{1, -1, 0, 0}, Quaternion{2, 2, 2, -2}}) {
    Scene scene = spun(Vec3::Zero());
    scene.bodies[0].X_WB.q_WB = q;
    scene.bodies[0].velocity.w_WB = lin_canny::rotation(q) * Vec3(0, 8, 0);
    const Compared c = compare(scene, 256);
    CAPTURE(q.w, q.x, q.y, q.z, c.off, c.claimed);
    CHECK(c.off <= c.claimed);
    CHECK(c.claimed < 1e-11);
  }
}

// I₃ = I₁ + I₂: |c₁| = |c₂| = 1, so the sign alone tells the middle axis, whatever the order of the axes.
TEST_CASE("a flat body stays where the reference says for many periods") {
  for (const Vec3& moments : {Vec3(2, 3, 5), Vec3(5, 2, 3), Vec3(3, 5, 2), Vec3(3, 2, 5)}) {
    Scene scene = spun({1, 2, 17});
    scene.bodies[0].mass = MassProperties{1, Vec3::Zero(), moments.asDiagonal()};
    for (const double t : {1.0, 4.0, 16.0}) {
      const Compared c = compare(scene, t);
      CAPTURE(moments.transpose(), t, c.off, c.claimed);
      CHECK(c.off <= c.claimed);
      CHECK(c.w_off <= c.w_claimed);
    }
  }
}

TEST_CASE("where nothing is known of a tumbling body, it says so, and keeps energy and momentum all the same") {
  // On the way to the middle axis: I_3(I_3 - I_2)/(I_1(I_2 - I_1)) = (ω_1/ω_3)².
  const Scene scene = [] {
    Scene s = spun(Vec3(1, 0.5, 1));
    s.bodies[0].mass = MassProperties{1, Vec3::Zero(), Vec3(2, 5, 6).asDiagonal()};
    return s;
  }();
  const RigidBodyModel model(scene.bodies[0]);
  const BallisticMotion motion(model, 0, scene.bodies[0].X_WB, scene.bodies[0].velocity, Vec3::Zero());
  CHECK(motion.kinematics(4).turn_error < 1e-12);
  const Vec3 I(2, 5, 6), w(1, 0.5, 1);
  for (const double t : {256.0, 4096.0}) {
    const Kinematics now = motion.kinematics(t);
    CHECK(now.turn_error >= 1);
    const Vec3 w_B = now.R_WB.transpose() * now.w_WB;
    const Vec3 L = now.R_WB * I.cwiseProduct(w_B);
    CHECK(w_B.dot(I.cwiseProduct(w_B)) == Approx(w.dot(I.cwiseProduct(w))).epsilon(1e-12));
    CHECK((L - I.cwiseProduct(w)).norm() < 1e-10);
  }
}

}  // namespace
}  // namespace touchstone::fast::motion
