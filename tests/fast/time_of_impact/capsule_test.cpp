// The capsule about a needle against the needle's own motion, and searches that it makes short.
#include "fast/time_of_impact/capsule.h"

#include <algorithm>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/time_of_impact/first_contact.h"
#include "reference/time_of_impact.h"
#include "tests/catch.h"

namespace touchstone::fast::time_of_impact {
namespace {

constexpr double thickness = 0x1p-8;

/// A tetrahedron 2 m long, about its centre of mass; it spins about its long axis, which turns slowly.
Body needle(double spin) {
  Body body;
  const double t = thickness;
  body.shape = Polytope{{{-1, -t, -t}, {1, -t, -t}, {0, 2 * t, -t}, {0, 0, 3 * t}},
                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  body.velocity.w_WB = {spin, 0.5, -1};
  return body;
}

struct Moving {
  explicit Moving(const Body& body) : model(body), motion(model, 0, body.X_WB, body.velocity, Vec3(0, 0, -8)) {}
  motion::RigidBodyModel model;
  motion::BallisticMotion motion;
};

TEST_CASE("capsule: the bounds on a needle's axis hold, and are far below those of its other points") {
  for (const double spin : {64.0, 1024.0, 4096.0}) {
    CAPTURE(spin);
    const Moving moving(needle(spin));
    const motion::Inertia& inertia = moving.model.inertia;
    int axis = 0;
    inertia.c.cwiseAbs().minCoeff(&axis);
    const auto axes = [&](double t) {
      return Mat3(moving.motion.kinematics(t).R_WB * lin_canny::rotation(inertia.q_BP));
    };
    const Vec3 w_P = axes(0).transpose() * moving.motion.kinematics(0).w_WB;
    const std::optional<AxisMotion> moves = axis_motion(inertia, axis, w_P, 0, moving.motion.rate());
    REQUIRE(moves.has_value());
    CHECK(moves->acceleration < 0.01 * moving.motion.rate() * moving.motion.rate());
    CHECK(moves->jerk < 0.01 * std::pow(moving.motion.rate(), 3));
    const double h = 0x1p-4 / spin;
    double greatest_second = 0, greatest_third = 0;
    for (int i = 0; i < 400; ++i) {
      const auto e = [&](int k) { return Vec3(axes((2 * i + k) * h).col(axis)); };
      greatest_second = std::max(greatest_second, (e(2) - 2 * e(1) + e(0)).norm() / (h * h));
      greatest_third = std::max(greatest_third, (e(3) - 3 * e(2) + 3 * e(1) - e(0)).norm() / (h * h * h));
    }
    const double rounding = 0x1p-46;  // of e, in a difference of several
    CHECK(greatest_second <= moves->acceleration + rounding / (h * h));
    CHECK(greatest_third <= moves->jerk + rounding / (h * h * h));
    CHECK(greatest_second > moves->acceleration / 16);
  }
}

TEST_CASE("capsule: it contains the needle, and its ends move as they say") {
  const Moving moving(needle(256));
  const motion::Origin O;
  for (int i = 0; i < 50; ++i) {
    const double t = 0.01 * i;
    const auto ends = capsule_about(moving.motion, 0, moving_core(moving.motion, 0, t, O));
    REQUIRE(ends.has_value());
    const auto& [first, last] = *ends;
    CHECK(first.radius < 4 * thickness);
    for (const double h : {0.0, 0x1p-10, 0x1p-6, 0x1p-3}) {
      CAPTURE(t, h);
      const MovingCore later = moving_core(moving.motion, 0, t + h, O);
      const auto end_later = *capsule_about(moving.motion, 0, later);
      for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        const MovingCore& ball = (*ends)[k];
        const Vec3 expected = ball.core.t + h * ball.v + h * h / 2 * ball.acceleration;
        const double off = (end_later[k].core.t - expected).norm();
        CHECK(off <= ball.jerk_bound * h * h * h / 6 + 1e-12);
      }
      const Vec3 from = end_later[0].core.t, way = end_later[1].core.t - from;
      for (int v = 0; v < later.core.hull->vertex_count(); ++v) {
        const Vec3 p = later.core.vertex(v) - from;
        const double along = std::clamp(p.dot(way) / way.squaredNorm(), 0.0, 1.0);
        CHECK((p - along * way).norm() <= first.radius);
      }
    }
  }
}

TEST_CASE("capsule: none about a body that is not thin, does not spin about its length, or is fixed") {
  const auto has_one = [](const Body& body) {
    const Moving moving(body);
    return capsule_about(moving.motion, 0, moving_core(moving.motion, 0, 0, {})).has_value();
  };
  Body body = needle(256);
  CHECK(has_one(body));
  body.mass = Fixed{};
  CHECK_FALSE(has_one(body));
  CHECK_FALSE(has_one(needle(1)));
  body = needle(256);
  body.shape = Box{{1, 0.5, 0.25}};
  CHECK_FALSE(has_one(body));
  body.shape = Box{{1, 1, thickness}};
  CHECK_FALSE(has_one(body));
}

// 0.6 s at 4096 rad/s are 2,458 rad. Each step is some radians at most without the capsule.
TEST_CASE("capsule: a needle that spins as it falls on a table is followed in few queries") {
  Scene scene;
  scene.gravity = {0, 0, -8};
  scene.bodies = {needle(4096), {}};
  scene.bodies[1].shape = Box{{8, 8, 1}};
  scene.bodies[1].X_WB.p_WB = {0, 0, -2.5};
  scene.bodies[1].mass = Fixed{};
  scene.motion.emplace();
  scene.motion->sample_times = {1};
  const motion::RigidBodyModel a(scene.bodies[0]), b(scene.bodies[1]);
  const motion::BallisticMotion falls(a, 0, {}, scene.bodies[0].velocity, scene.gravity);
  const motion::BallisticMotion rests(b, 0, scene.bodies[1].X_WB, {}, Vec3::Zero());
  const FirstContact found = first_contact(falls, rests, 0, 1);
  REQUIRE(found.status == TimeOfImpact::Status::hit);
  CHECK(found.queries < 200);
  const reference::TimeOfImpactTruth truth = reference::time_of_impact(scene);
  CHECK(found.lo <= truth.time.hi);
  CHECK(found.hi >= truth.time.lo);
}

}  // namespace
}  // namespace touchstone::fast::time_of_impact
