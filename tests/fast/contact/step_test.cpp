// Steps of bodies in contact whose motion is known.
#include "fast/contact/step.h"

#include <cmath>

#include "fast/motion/rigid_body_model.h"
#include "tests/catch.h"
#include "tests/fast/contact/axes.h"

namespace touchstone::fast::contact {
namespace {

constexpr double g = 10, h = 0x1p-6, tolerance = 0x1p-40, recovery = 0x1p-10;

motion::RigidBodyModel ball_model(double mass) {
  Body ball;
  ball.shape = Sphere{1};
  ball.mass = MassProperties{mass, Vec3::Zero(), 0.4 * mass * Mat3::Identity()};
  return motion::RigidBodyModel(ball);
}

motion::RigidBodyModel floor_model() {
  Body floor;
  floor.shape = Box{Vec3(9, 9, 1)};
  floor.mass = Fixed{};
  return motion::RigidBodyModel(floor);
}

const Feature centre{Feature::Kind::point, Vec3::Zero(), Vec3::Zero(), 1};
const Feature face{Feature::Kind::plane, Vec3::Zero(), z, 0};

/// A ball of mass 2 and radius 1 on the face z = 0 of a fixed floor.
class BallOnFloor {
 public:
  BallOnFloor(const Velocity& velocity, double friction, double height = 1)
      : ball_(ball_model(2)),
        floor_(floor_model()),
        bodies_{{&ball_, {{Vec3(0, 0, height), {}}, velocity}, -g * z}, {&floor_, {}, Vec3::Zero()}},
        constraints_{{0, 1, {centre, face}, z, friction}} {}
  BallOnFloor(const BallOnFloor&) = delete;
  BallOnFloor& operator=(const BallOnFloor&) = delete;

  Stepped stepped() { return step(bodies_, constraints_, h, tolerance, recovery); }
  const Vec3& force() const { return constraints_[0].contact_point.F_A_W; }
  std::vector<StepBody>& bodies() { return bodies_; }
  std::vector<ContactConstraint>& constraints() { return constraints_; }

 private:
  motion::RigidBodyModel ball_, floor_;
  std::vector<StepBody> bodies_;
  std::vector<ContactConstraint> constraints_;
};

TEST_CASE("step: a ball on a floor rests, and its weight is the contact's force") {
  BallOnFloor scene({}, 0.5);
  const Stepped done = scene.stepped();
  CHECK(scene.force().z() == Approx(2 * g));
  CHECK((done.after[0].X_WB.p_WB - z).norm() < tolerance);
  CHECK(done.after[0].velocity.v_WBcm.norm() < 1e-12);
  CHECK(done.residual <= tolerance);
}

TEST_CASE("step: a ball that is high enough falls on its parabola") {
  BallOnFloor scene({Vec3(3, 0, 0), Vec3::Zero()}, 0.5, 2);
  const Stepped done = scene.stepped();
  CHECK(scene.force().isZero(0));
  CHECK((done.after[0].X_WB.p_WB - Vec3(3 * h, 0, 2 - g * h * h / 2)).norm() < 1e-15);
  CHECK((done.after[0].velocity.v_WBcm - Vec3(3, 0, -g * h)).norm() < 1e-15);
  CHECK(done.residual == 0);
}

// Friction μ m g: v' = v − μ g h, and the slip's rate is 7/2 of that.
TEST_CASE("step: a ball that slides loses mu g h of its speed, and starts to spin") {
  const double mu = 0.25;
  BallOnFloor scene({Vec3(4, 0, 0), Vec3::Zero()}, mu);
  const Stepped done = scene.stepped();
  CHECK(done.after[0].velocity.v_WBcm.x() == Approx(4 - mu * g * h));
  CHECK(done.after[0].velocity.w_WB.y() == Approx(2.5 * mu * g * h));
  CHECK(done.after[0].X_WB.p_WB.x() == Approx(4 * h - mu * g * h * h / 2));
  CHECK((scene.force() - 2 * g * Vec3(-mu, 0, 1)).norm() < 2e-12 / h);
  CHECK(done.residual <= tolerance);
}

// Slip is gone after v/(7/2 μ g): 0.29 and 0.73 of the step. The ball then rolls at 5/7 of v; not with slip reversed.
TEST_CASE("step: a ball whose slip ends in the step rolls after it") {
  const double mu = 0.25;
  for (const double v : {0.04, 0.1}) {
    BallOnFloor scene({Vec3(v, 0, 0), Vec3::Zero()}, mu);
    const Stepped done = scene.stepped();
    CHECK(done.after[0].velocity.v_WBcm.x() == Approx(5 * v / 7));
    CHECK(done.after[0].velocity.w_WB.y() == Approx(5 * v / 7));
    CHECK(std::abs(done.after[0].X_WB.p_WB.x() - 5 * v * h / 7) < v * h / 4);
  }
}

// By Cayley's map it would be h³|w|³/12 = 1e-3 rad less.
TEST_CASE("step: a ball that slides turns by the whole angle of its mean angular velocity") {
  BallOnFloor scene({Vec3(4, 0, 0), Vec3(0, 15, 0)}, 0.25);
  const Stepped done = scene.stepped();
  const Quaternion& q = done.after[0].X_WB.q_WB;
  CHECK(2 * std::atan2(q.y, q.w) == Approx(h * done.mean[0].w.y()).epsilon(1e-12));
}

// On slopes rounding leaves a tangential part of the impulse, which is no friction. Where the ball comes down in the
// step, or is lifted, its contact point also moves along the normal at the end.
TEST_CASE("step: without friction a ball keeps its spin, on a slope too") {
  const motion::RigidBodyModel model = ball_model(2), below = floor_model();
  for (const Vec3& n : {z, Vec3(Vec3(5, 0, 12) / 13), Vec3(Vec3(2, 1, 2) / 3), Vec3(Vec3(2, 3, 6) / 7)}) {
    const Vec3 along = n.cross(Vec3(1, 2, 0)).normalized(), w(0.25, 2, 1);
    for (const double height : {1 - 0x1p-20, 1.0, 1 + 0x1p-20, 1 + 0x1p-12}) {
      const State start{{height * n, {}}, {along, w}};
      const std::vector<StepBody> bodies = {{&model, start, -g * z}, {&below, {}, Vec3::Zero()}};
      const Feature slope{Feature::Kind::plane, Vec3::Zero(), n, 0};
      std::vector<ContactConstraint> constraints = {{0, 1, {centre, slope}, n, 0}};
      const Velocity V = step(bodies, constraints, h, tolerance, recovery).after[0].velocity;
      const Vec3 off = V.v_WBcm - (along - g * h * z);
      CHECK((V.w_WB - w).norm() < 1e-14);
      CHECK((off - n.dot(off) * n).norm() < 1e-12);
    }
  }
}

TEST_CASE("step: a ball that rolls goes on rolling") {
  BallOnFloor scene({Vec3(4, 0, 0), Vec3(0, 4, 0)}, 0.25);
  const Stepped done = scene.stepped();
  CHECK((done.after[0].velocity.v_WBcm - Vec3(4, 0, 0)).norm() < 1e-11);
  CHECK((done.after[0].velocity.w_WB - Vec3(0, 4, 0)).norm() < 1e-11);
  CHECK(done.after[0].X_WB.p_WB.x() == Approx(4 * h));
}

// Sweeps alone would need thousands. With one sweep a round the residual is far above the tolerance.
TEST_CASE("step: a tower with a thousandfold mass on top is solved to the tolerance, and its residual says so") {
  const motion::RigidBodyModel light = ball_model(1), heavy = ball_model(1000), floor = floor_model();
  const auto at = [](double height) { return State{{height * z, {}}, {}}; };
  const std::vector<StepBody> tower = {
      {&light, at(1), -g * z}, {&light, at(3), -g * z}, {&heavy, at(5), -g * z}, {&floor, {}, Vec3::Zero()}};
  std::vector<ContactConstraint> constraints = {
      {0, 3, {centre, face}, z, 0.5}, {1, 0, {centre, centre}, z, 0.5}, {2, 1, {centre, centre}, z, 0.5}};
  const Stepped done = step(tower, constraints, h, tolerance, recovery);
  CHECK(done.residual <= tolerance);
  CHECK(constraints[0].contact_point.F_A_W.z() == Approx(1002 * g).epsilon(1e-9));
  for (std::size_t i = 0; i < 3; ++i)
    CHECK((done.after[i].X_WB.p_WB - tower[i].state.X_WB.p_WB).norm() <= 2 * tolerance);
}

TEST_CASE("step: an overlap is removed, but no faster than the recovery speed") {
  BallOnFloor little({}, 0, 1 - h * recovery / 2), deep({}, 0, 1 - 4 * h * recovery);
  CHECK(little.stepped().after[0].X_WB.p_WB.z() == Approx(1).epsilon(1e-12));
  CHECK(deep.stepped().after[0].X_WB.p_WB.z() == Approx(1 - 3 * h * recovery).epsilon(1e-12));
}

TEST_CASE("step: kinetic energy never grows, however long the step is") {
  BallOnFloor scene({Vec3(2, 1, -3), Vec3(5, -7, 2)}, 0.5);
  scene.bodies()[0].acceleration.setZero();
  const auto energy = [](const State& state) {
    return state.velocity.v_WBcm.squaredNorm() + 0.4 * state.velocity.w_WB.squaredNorm();
  };
  const double before = energy(scene.bodies()[0].state);
  for (const double long_step : {0x1p-6, 1.0, 64.0})
    CHECK(energy(step(scene.bodies(), scene.constraints(), long_step, tolerance, recovery).after[0]) <= before);
}

// The ball is pressed onto an edge of a cube that turns under it, so its gap changes along a curve.
TEST_CASE("step: a ball that rolls along an edge that turns gains no energy") {
  Body body;
  body.shape = Box{Vec3(1, 1, 1)};
  body.mass = MassProperties{3, Vec3::Zero(), 2 * Mat3::Identity()};
  const motion::RigidBodyModel ball = ball_model(2), cube(body);
  const Vec3 n = Vec3(0, 1, 1).normalized();
  const Feature edge{Feature::Kind::line, Vec3(0, 1, 1), Vec3(1, 0, 0), 0};
  const auto energy = [](const std::vector<State>& states) {
    const auto of = [](double mass, double moment, const State& s, double acceleration) {
      return mass * (s.velocity.v_WBcm.squaredNorm() / 2 - acceleration * s.X_WB.p_WB.z()) +
             moment / 2 * s.velocity.w_WB.squaredNorm();
    };
    return of(2, 0.8, states[0], -g) + of(3, 2, states[1], g);
  };
  for (const double speed : {-4.0, -2.0, 2.0, 4.0}) {
    for (const double turn : {-3.0, 3.0}) {
      const Vec3 v(speed, 0, 0), w = turn * n, p(0.25, 1, 1);
      const std::vector<State> start = {{{p + n, {}}, {v, n.cross(v - w.cross(p))}},
                                        {{Vec3::Zero(), {}}, {Vec3::Zero(), w}}};
      const std::vector<StepBody> bodies = {{&ball, start[0], -g * z}, {&cube, start[1], g * z}};
      std::vector<ContactConstraint> constraints = {{0, 1, {centre, edge}, n, 4}};
      const Stepped done = step(bodies, constraints, h, tolerance, recovery);
      CHECK(done.residual <= 1e-9);
      CHECK(constraints[0].contact_point.F_A_W.norm() > 1);
      const double gained = energy(done.after) - energy(start);  // where u_n is not corrected: up to ±1.4e-4 J
      CHECK(gained <= 1e-12);
      CHECK(gained >= -1e-5);
    }
  }
}

TEST_CASE("unbalanced: 0 if the floor carries the ball, 1 if nothing does, and what friction cannot hold on a slope") {
  BallOnFloor flat({}, 0.5);
  CHECK(unbalanced(flat.bodies(), flat.constraints()) < 1e-12);
  CHECK(flat.force().z() == Approx(2 * g));
  std::vector<ContactConstraint> none;
  CHECK(unbalanced(flat.bodies(), none) == 1);
  BallOnFloor slope({}, 0);  // without friction, gravity's part along the floor remains
  slope.bodies()[0].acceleration = g * Vec3(0.6, 0, -0.8);
  CHECK(unbalanced(slope.bodies(), slope.constraints()) == Approx(0.6));
}

TEST_CASE("land: removes the approach, without restitution and with friction") {
  BallOnFloor scene({Vec3(7, 0, -8), Vec3::Zero()}, 0.5);
  land(scene.bodies(), scene.constraints());
  CHECK((scene.bodies()[0].state.velocity.v_WBcm - Vec3(5, 0, 0)).norm() < 1e-12);
  CHECK((scene.bodies()[0].state.velocity.w_WB - Vec3(0, 5, 0)).norm() < 1e-12);
}

}  // namespace
}  // namespace touchstone::fast::contact
