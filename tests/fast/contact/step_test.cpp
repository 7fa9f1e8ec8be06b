// One contact step by the formulas of a textbook, and that it never adds energy.
#include "fast/contact/step.h"

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::contact {
namespace {

const Vec3 still = Vec3::Zero(), up(0, 0, 1), g(0, 0, -10);

/// A ball of 1 kg and 1 m (0) that touches a fixed floor (1) at one point.
struct OnFloor {
  OnFloor(const Vec3& v, const Vec3& acceleration, double friction)
      : ball_body(ball(1, up, v, {})), floor_body(table()), ball_model(ball_body), floor_model(floor_body) {
    bodies = {{&ball_model, {ball_body.X_WB, ball_body.velocity}, acceleration},
              {&floor_model, {floor_body.X_WB, floor_body.velocity}, still}};
    const Feature centre{Feature::Kind::point, still, still, 1}, face{Feature::Kind::plane, up, up, 0};
    constraints = {{0, 1, {centre, face}, up, friction}};
  }
  State after(double h) { return step(bodies, constraints, h, 1e-9, 1).after[0]; }

  Body ball_body, floor_body;
  motion::RigidBodyModel ball_model, floor_model;
  std::vector<StepBody> bodies;
  std::vector<ContactConstraint> constraints;
};

TEST_CASE("contact step: without contact a parabola") {
  OnFloor flies({1, 0, 5}, g, 0);
  const State state = flies.after(0.5);
  CHECK(state.X_WB.p_WB.x() == Approx(0.5));
  CHECK(state.X_WB.p_WB.z() == Approx(1 + 2.5 - 1.25));
  CHECK(state.velocity.v_WBcm.z() == Approx(0).margin(1e-12));
}

TEST_CASE("contact step: a ball slides, and friction turns it") {
  OnFloor slides({7, 0, 0}, g, 0.5);
  const State state = slides.after(0.01);
  CHECK(state.velocity.v_WBcm.x() == Approx(7 - 5 * 0.01));
  CHECK(state.velocity.v_WBcm.z() == Approx(0).margin(1e-6));
  CHECK(state.velocity.w_WB.y() == Approx(12.5 * 0.01));
  CHECK(state.X_WB.p_WB.x() == Approx(0.07 - 2.5e-4));
  CHECK(state.X_WB.p_WB.z() == Approx(1));
}

TEST_CASE("contact step: however long, it adds no energy") {
  for (const double h : {0.01, 0.1, 1.0}) {
    for (const double friction : {0.0, 0.3, 2.0}) {
      CAPTURE(h, friction);
      OnFloor lands({3, 1, -2}, g, friction);
      const State state = lands.after(h);
      const double before = 0.5 * 14 + 10, spin = 0.5 * 0.4 * state.velocity.w_WB.squaredNorm();
      CHECK(0.5 * state.velocity.v_WBcm.squaredNorm() + spin + 10 * state.X_WB.p_WB.z() <= before + 1e-6);
      CHECK(state.X_WB.p_WB.z() >= 1 - 1e-6);
    }
  }
}

TEST_CASE("contact step: an overlap is undone no faster than allowed") {
  OnFloor deep(still, still, 0);
  deep.bodies[0].state.X_WB.p_WB.z() = 0.75;
  const State state = step(deep.bodies, deep.constraints, 0.125, 1e-9, 1).after[0];
  CHECK(state.X_WB.p_WB.z() == Approx(0.75 + 0.125));
}

TEST_CASE("contact step: landing removes approach, with friction and without restitution") {
  OnFloor lands({7, 0, -3}, g, 0.25);
  land(lands.bodies, lands.constraints);
  const Velocity& velocity = lands.bodies[0].state.velocity;
  CHECK(velocity.v_WBcm.x() == Approx(7 - 0.75));
  CHECK(velocity.v_WBcm.z() == Approx(0).margin(1e-9));
  CHECK(velocity.w_WB.y() == Approx(0.75 / 0.4));
}

TEST_CASE("contact step: what contact forces leave of the applied accelerations") {
  OnFloor lies(still, g, 0);
  CHECK(unbalanced(lies.bodies, lies.constraints) < 1e-9);
  CHECK(lies.constraints[0].contact_point.P_A_W.z() == Approx(10));
  OnFloor slips(still, {6, 0, -8}, 0);
  CHECK(unbalanced(slips.bodies, slips.constraints) == Approx(0.6));
  std::vector<ContactConstraint> no_contact;
  CHECK(unbalanced(lies.bodies, no_contact) == Approx(1));
}

}  // namespace
}  // namespace touchstone::fast::contact
