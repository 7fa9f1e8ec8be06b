// Trajectories by hand, the kinds of bodies that have closed forms, and boxes that contain what moves.
#include "fast/simulation/prediction/body_motion.h"

#include <cmath>

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("body motion: balls and fixed boxes that do not turn have closed forms") {
  const auto kind = [](const Body& body) { return BodyMotion(body, 0, g_W).kind(); };
  CHECK(kind(ball(1, Vec3::Zero(), Vec3::Zero(), {})) == Kind::ball);
  CHECK(kind(table()) == Kind::block);
  CHECK(kind(brick({1, 1, 1}, Vec3::Zero(), {})) == Kind::other);
  Body turntable = table();
  turntable.velocity.w_WB = {0, 0, 1};
  CHECK(kind(turntable) == Kind::other);
  Body loaded = ball(1, Vec3::Zero(), Vec3::Zero(), {});
  loaded.mass = MassProperties{1, {0.1, 0, 0}, Mat3::Identity()};
  CHECK(kind(loaded) == Kind::other);
}

TEST_CASE("body motion: a ball in free fall from its start on") {
  Body body = ball(2, {1, 0, 5}, {3, 0, 10}, {}, 4);
  body.velocity.w_WB = {0, 0, 0.5};
  const BodyMotion motion(body, 1, g_W);
  CHECK(motion.inverse_mass() == 0.25);
  CHECK(motion.inverse_moment() == Approx(1 / (0.4 * 4 * 4)));
  const State state = motion.state(3);  // after 2 s
  CHECK(state.X_WB.p_WB == Vec3(7, 0, 5));
  CHECK(state.velocity.v_WBcm == Vec3(3, 0, -10));
  CHECK(state.X_WB.q_WB.w == Approx(std::cos(0.5)));
  CHECK(state.X_WB.q_WB.z == Approx(std::sin(0.5)));
  const Aabb box = motion.box(1, 3, 0.25);  // its apex is 5 m above its start, at 2 s
  CHECK(box.lo.x() == Approx(1 - 2.25));
  CHECK(box.hi.x() == Approx(7 + 2.25));
  CHECK(box.lo.z() == Approx(5 - 2.25));
  CHECK(box.hi.z() == Approx(10 + 2.25));
}

TEST_CASE("body motion: a body with corners falls as its centre of mass does, and its box holds it however it turns") {
  Body body = brick({1, 2, 2}, {0, 0, 0}, {});
  body.velocity = {{1, 0, 0}, {0, 0, 2}};
  const BodyMotion motion(body, 0, g_W);
  CHECK(motion.radius() == Approx(3));
  const State state = motion.state(2);
  CHECK(state.X_WB.p_WB.x() == Approx(2));
  CHECK(state.X_WB.p_WB.z() == Approx(-20));
  CHECK(std::abs(state.X_WB.q_WB.w) == Approx(std::abs(std::cos(2.0))));
  const Aabb box = motion.box(0, 2, 0);
  CHECK(box.lo.x() <= -1);
  CHECK(box.hi.x() >= 2 + 1);
  CHECK(box.lo.z() <= -22);
  CHECK(box.hi.z() >= 2);
  CHECK(box.hi.x() <= 2 + 3.001);  // no farther out than its corners
}

TEST_CASE("body motion: a fixed body ignores gravity, and one that moves keeps its velocity") {
  Body body = table();
  CHECK(is_stationary(BodyMotion(body, 0, g_W)));
  body.velocity.v_WBcm = {1, 0, 0};
  const BodyMotion motion(body, 0, g_W);
  CHECK_FALSE(is_stationary(motion));
  CHECK(motion.state(3).X_WB.p_WB == Vec3(3, 0, -1));
  CHECK(motion.state(3).velocity.v_WBcm == Vec3(1, 0, 0));
}

TEST_CASE("body motion: what restarts at a reported state continues from exactly that state") {
  Body body = ball(1, {0.1, 0.2, 0.3}, {1, 2, 3}, {});
  body.velocity.w_WB = {0.3, 0.1, 0.7};
  BodyMotion motion(body, 0, g_W);
  const State state = motion.state(0.7);
  motion.restart(0.7, state, g_W);
  CHECK(motion.state(0.7).X_WB.p_WB == state.X_WB.p_WB);
  CHECK(motion.state(0.7).velocity == state.velocity);
}

TEST_CASE("body motion: a ball whose axis turns restarts before its orientation takes too long to compute") {
  BodyMotion motion(ball(1, Vec3::Zero(), Vec3::Zero(), {}), 0, g_W);
  const State spins{{Vec3::Zero(), {}}, {{7, 0, 0}, {0, 0, 0x1p13}}};
  motion.restart(0, spins, {-2, 0, 0}, {0, -5, 0});
  CHECK_FALSE(motion.needs_restart(0.5));
  CHECK(motion.needs_restart(1.5));
  CHECK(motion.follows(1.5));
  CHECK_FALSE(motion.follows(2.5));
  motion.restart(0, spins, {-2, 0, 0}, {0, 0, -5});  // about its own axis: in closed form
  CHECK_FALSE(motion.needs_restart(4));
  CHECK(motion.follows(4));
}

TEST_CASE("body motion: a step has a constant angular velocity even about no principal axis, and is never too long") {
  Body body = brick({1, 2, 3}, Vec3::Zero(), {});
  BodyMotion motion(body, 0, g_W);
  motion.follow_step(1, {{Vec3::Zero(), {}}, {{4, 0, 0}, Vec3::Zero()}}, {2, 0, 0}, {1e5, 1e5, 0});
  CHECK(motion.state(2).X_WB.p_WB.x() == Approx(5));
  CHECK(motion.state(2).velocity.w_WB.x() == Approx(1e5));
  CHECK(motion.state(2).velocity.w_WB.y() == Approx(1e5));
  CHECK_FALSE(motion.needs_restart(2));
  motion.restart(1, {{Vec3::Zero(), {}}, {Vec3::Zero(), {1e5, 1e5, 0}}}, g_W);
  CHECK(motion.needs_restart(2));
}

}  // namespace
}  // namespace touchstone::fast::simulation
