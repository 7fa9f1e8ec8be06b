// The bounds hold, and they are not far too large: a plain computation in binary32 is compared with each from both
// sides.
#include "oracle/tolerance/tolerance.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>

#include "oracle/tolerance/constraint.h"
#include "oracle/tolerance/precision.h"
#include "oracle/truth/world_points.h"
#include "tests/catch.h"

using namespace touchstone;
using oracle::Precision;

namespace {

// Numbers in (-1, 1) that floats represent exactly, the same on every machine: the upper bits of a linear congruential
// generator.
class Floats {
 public:
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(static_cast<std::int64_t>(state_ >> 40) - (1 << 23)) * 0x1p-23;
  }
  Vec3 point() { return {next(), next(), next()}; }

 private:
  std::uint64_t state_ = 2026;
};

Scene of(Shape shape, const Pose& X_WB = {}) {
  Body body;
  body.shape = std::move(shape);
  body.X_WB = X_WB;
  Scene scene;
  scene.bodies = {body};
  return scene;
}

// As engines transform a point: normalise, make a matrix, multiply, add.
Eigen::Vector3f placed(const Pose& X, const Vec3& p) {
  const Eigen::Quaternionf q(Eigen::Quaterniond(X.q_WB.w, X.q_WB.x, X.q_WB.y, X.q_WB.z).cast<float>());
  return q.normalized().toRotationMatrix() * p.cast<float>() + X.p_WB.cast<float>();
}

}  // namespace

TEST_CASE("scale: the farthest coordinate of an origin, and the radius about it") {
  CHECK(oracle::tolerance::scale(of(Sphere{2}, {{3, -5, 1}, {}})) == 7);
  CHECK(oracle::tolerance::scale(of(Box{{1, 2, 2}})) == 3);
  CHECK(oracle::tolerance::scale(of(Compound{{{Pose{{0, 4, 0}, {}}, Sphere{1}}, {Pose{}, Sphere{2}}}})) == 5);
  CHECK(oracle::tolerance::scale(Scene{}) == 0);
}

TEST_CASE("ulps follow the precision") {
  const Scene scene = of(Sphere{1});
  CHECK(oracle::tolerance::ulp(scene, Precision::binary64) == 0x1p-53);
  CHECK(oracle::tolerance::ulp(scene, Precision::exact) == 0x1p-53);
  CHECK(oracle::tolerance::ulp(scene, Precision::binary32) == 0x1p-24);
  CHECK(oracle::tolerance::distance(scene, Precision::exact) < oracle::tolerance::distance(scene, Precision::binary64));
}

TEST_CASE("a point through one pose in binary32 is within 52 ulps of S, and not always within 0.5") {
  Floats random;
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec3 v = random.point();
    const Pose X{random.point(), {random.next(), random.next(), random.next(), random.next()}};
    const Scene scene = of(Polytope{{v}, {}}, X);
    const oracle::Point exact = oracle::world_points(scene.bodies[0], 0).front();
    const double error = static_cast<double>((placed(X, v).cast<oracle::Real>() - exact).norm());
    worst = std::max(worst, error / oracle::tolerance::ulp(scene, Precision::binary32));
  }
  CHECK(worst < 52);
  CHECK(worst > 0.5);
}

TEST_CASE("a direction normalised in binary32 is within unit_length of 1, and not always 1") {
  Floats random;
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const Eigen::Vector3f n = random.point().cast<float>().normalized();
    worst = std::max(worst, std::abs(n.cast<double>().norm() - 1));
  }
  CHECK(worst < oracle::tolerance::unit_length(Precision::binary32));
  CHECK(worst > 0);
}

// A contact normal is normalised in the frame of one body, and turned into that of the other and into the world's.
TEST_CASE(
    "a direction turned twice in binary32 is within unit_length of 1, and not always within that of one not turned") {
  Floats random;
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto turn = [&] {
      return Eigen::Quaternionf(
                 Eigen::Quaterniond(random.next(), random.next(), random.next(), random.next()).cast<float>())
          .normalized();
    };
    const Eigen::Vector3f n_B = random.point().cast<float>().normalized();
    const Eigen::Quaternionf one = turn(), other = turn();
    const Eigen::Vector3f n = other.toRotationMatrix() * (one.toRotationMatrix() * n_B);
    worst = std::max(worst, std::abs(n.cast<double>().norm() - 1));
  }
  CHECK(worst < oracle::tolerance::unit_length(Precision::binary32));
  CHECK(worst > 4 * 0x1p-24);
}

TEST_CASE("a tetrahedron's mass and centre in binary32, seen from its first vertex, are within the bound") {
  Floats random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 far = 1024 * random.point();
    std::vector<Vec3> v;
    // Rounds to a grid that floats represent, not by a cast to float and back: g++ 12 omits that rounding in vectorised
    // code.
    for (int k = 0; k < 4; ++k) v.emplace_back((0x1p12 * (far + random.point())).array().round() * 0x1p-12);
    const double V = (v[1] - v[0]).dot((v[2] - v[0]).cross(v[3] - v[0])) / 6;
    if (V < 1e-3) continue;
    Body body;
    body.shape = Polytope{v, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    const auto seen = [&](std::size_t k) { return Eigen::Vector3f(v[k].cast<float>() - v[0].cast<float>()); };
    const float volume = seen(1).dot(seen(2).cross(seen(3))) / 6;
    const Eigen::Vector3f centre = v[0].cast<float>() + (seen(1) + seen(2) + seen(3)) / 4;
    const Vec3 exact = (v[0] + v[1] + v[2] + v[3]) / 4;
    const oracle::tolerance::MassBound bound = oracle::tolerance::mass(body, Precision::binary32);
    CHECK(std::abs(static_cast<double>(volume) - V) < bound.mass);
    CHECK((centre.cast<double>() - exact).cwiseAbs().maxCoeff() < bound.centre);
    CHECK(bound.mass < 1e-3);  // however far the body is from its origin
  }
}

TEST_CASE("exact_in: every number of shape, pose and mass must be a float") {
  const Precision single = Precision::binary32;
  CHECK(oracle::exact_in(of(Sphere{0.5}), single));
  CHECK_FALSE(oracle::exact_in(of(Sphere{0.1}), single));
  CHECK(oracle::exact_in(of(Sphere{0.1}), Precision::binary64));
  CHECK_FALSE(oracle::exact_in(of(Box{{1, 1, 1e300}}), single));
  CHECK_FALSE(oracle::exact_in(of(Sphere{1}, {{0, 0x1p-200, 0}, {}}), single));
  CHECK_FALSE(oracle::exact_in(of(Sphere{1}, {{0, 0, 0}, {1, 0, 0, 1 + 0x1p-30}}), single));
  CHECK_FALSE(oracle::exact_in(of(Compound{{{Pose{{0.3, 0, 0}, {}}, Sphere{1}}}}), single));
  Scene dense = of(Sphere{1});
  dense.bodies[0].mass = Density{0.7};
  CHECK_FALSE(oracle::exact_in(dense, single));
}

namespace {

/// How many samples, at 1/4, 3/4 and 1 s, are certain of a ball that makes one change, at 1/2 s and at this rate. Steps
/// are 2^-10 s and the acceleration 8 m/s², so the velocity is off by V = 2^-7 m/s, and V + A δ = 2^-6 m/s.
std::size_t certain_samples(Event::Kind kind, double rate, const std::array<double, 2>& clearances = {64, 64}) {
  Scene scene = of(Sphere{64});  // so great that the ball stays far from where nothing is certain
  scene.gravity = Vec3::Zero();
  scene.bodies.push_back(scene.bodies[0]);
  scene.motion.emplace();
  scene.motion->sample_times = {0.25, 0.75, 1};
  reference::ConstraintTruth truth;
  truth.first = {reference::ConstraintTruth::Mode::ballistic, 8, clearances[0]};
  reference::ConstraintTruth::Change change;
  change.kind = kind;
  change.time = {0.5, 0.5};
  change.other = 1;
  change.rate = rate;
  change.segment = truth.first;
  change.segment.clearance = clearances[1];
  truth.changes = {change};
  return oracle::tolerance::rolling(scene, truth, Precision::binary64, 0x1p-10).size();
}

}  // namespace

TEST_CASE("a ball that touches a box, or leaves its edge, slower than twice what its velocity is off may not do so") {
  for (const Event::Kind kind : {Event::Kind::impact, Event::Kind::release}) {
    CHECK(certain_samples(kind, 0x1.1p-5) == 3);
    CHECK(certain_samples(kind, 0x1p-5) == 1);
    CHECK(certain_samples(kind, 0x1p-6) == 1);
  }
  CHECK(certain_samples(Event::Kind::contact, 0x1p-6) == 3);  // slip stops in any case: its rate is a deceleration
}

// The second segment ends at the last sample, so its clearance may be 0. A segment without duration has an infinite
// one.
TEST_CASE("where a ball meets a box exactly at the end, nothing is certain of it from the change before") {
  CHECK(certain_samples(Event::Kind::contact, 1, {64, 0}) == 1);
  CHECK(certain_samples(Event::Kind::contact, 1, {64, infinity}) == 3);
  CHECK(certain_samples(Event::Kind::contact, 1, {0, 64}) == 0);
}
