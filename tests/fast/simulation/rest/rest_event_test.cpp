// A ball that comes to rest on a table, changes from slip to rolling, and leaves.
#include "fast/simulation/rest/rest_event.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

/// A ball (0) on a table (1).
struct OnTable {
  explicit OnTable(const Vec3& v)
      : scene(moving_scene({ball(1, up, v, {0, 0.5}), table()}, g_W, {4})), run(scene, {.frame = 4}) {
    run.schedule.begin_frame();
    run.schedule.predict_frame();
  }
  RestCandidate candidate() const { return rest_candidate(run.world, 0, 1, {0, still, up}).value(); }
  Event last_event() { return run.recorder.take({}).trajectory.events->back(); }

  Scene scene;
  Run run;
};

TEST_CASE("rest event: only a body that moves may rest on a fixed one") {
  const Scene scene = moving_scene({table(), ball(1, up, {1, 0, -1}, {}), ball(1, {9, 0, 1}, still, {})}, g_W, {1});
  const World world(scene);
  CHECK_FALSE(rest_candidate(world, 1, 2, {0, still, up}).has_value());
  const std::optional<RestCandidate> found = rest_candidate(world, 0, 1, {0, still, -up});
  REQUIRE(found.has_value());
  CHECK(found->id == 1);
  CHECK(found->on == 0);
  CHECK(found->nhat_W == up);
  CHECK(found->state.velocity.v_WBcm == Vec3(1, 0, 0));
  CHECK(closed_form_rest(world, *found, 1).has_value());
}

TEST_CASE("rest event: no closed form on a body that is no block") {
  Body turntable = table();
  turntable.velocity.w_WB = {0, 0, 1};
  const Scene scene = moving_scene({ball(1, up, still, {}), turntable}, g_W, {1});
  const World world(scene);
  const std::optional<RestCandidate> found = rest_candidate(world, 0, 1, {0, still, up});
  REQUIRE(found.has_value());
  CHECK_FALSE(closed_form_rest(world, *found, 1).has_value());
}

TEST_CASE("rest event: a ball that hits a ceiling without restitution falls") {
  const Scene scene = moving_scene({ball(1, {0, 0, -3}, {1, 0, 2}, {0, 1}), table()}, g_W, {0.5});
  const World world(scene);
  const std::optional<RestCandidate> found = rest_candidate(world, 0, 1, {0, {0, 0, -2}, -up});
  REQUIRE(found.has_value());
  CHECK_FALSE(closed_form_rest(world, *found, 1).has_value());
  const State after = simulate(scene).trajectory.states[0][0];
  CHECK(after.X_WB.p_WB.z() == Approx(-4.25));
  CHECK(after.velocity.v_WBcm.z() == Approx(-5));
  CHECK(after.velocity.v_WBcm.x() == Approx(5.0 / 7));
}

TEST_CASE("rest event: a contact that starts is an event with the impulse of what is lost") {
  OnTable ball({7, 0, -2});
  REQUIRE(try_rest(ball.run, ball.candidate(), {7, 0, -2}, {}, 0));
  REQUIRE(ball.run.rests.of(0) != nullptr);
  CHECK(ball.run.rests.rests_on(0, 1));
  CHECK(ball.run.world.body(0).path().a.x() == Approx(-5));
  REQUIRE(ball.run.schedule.next() != nullptr);
  CHECK(ball.run.schedule.next()->time == Approx(0.4));  // 2v/(7 μ g), when slip ends
  const Event event = ball.last_event();
  CHECK(event.kind == Event::Kind::contact);
  CHECK(event.P_A_W.z() == Approx(2));
  CHECK(event.p_WC == still);
  CHECK(event.nhat_BA_W == up);
}

TEST_CASE("rest event: slip ends in rolling") {
  OnTable ball({7, 0, 0});
  REQUIRE(try_rest(ball.run, ball.candidate(), {7, 0, 0}, {}, 0));
  ball.run.advance_to(ball.run.rests.of(0)->until);
  end_rest_phase(ball.run, 0);
  REQUIRE(ball.run.rests.of(0) != nullptr);
  const State rolls = ball.run.world.body(0).state(ball.run.world.now());
  CHECK(rolls.velocity.v_WBcm.x() == Approx(5));
  CHECK(rolls.velocity.w_WB.y() == Approx(5));
  CHECK(ball.run.world.body(0).path().a == still);
  CHECK(ball.run.recorder.statistics().of(Event::Kind::contact) == 2);
}

TEST_CASE("rest event: a ball that spins fast about the normal restarts, and its contact's impulse is still whole") {
  OnTable ball({7, 0, 0});
  RestCandidate candidate = ball.candidate();
  candidate.state.velocity.w_WB.z() = 0x1p11;
  REQUIRE(try_rest(ball.run, candidate, {7, 0, 0}, {}, 0));
  const double until = ball.run.rests.of(0)->until;
  CHECK(until == Approx(0.4));
  ball.run.advance_to(0.25);
  REQUIRE(ball.run.world.keep_orientation(0, 4.25));
  CHECK(ball.run.world.body(0).path().since == 0.25);
  CHECK(ball.run.world.body(0).path().alpha.y() == Approx(12.5));
  CHECK(ball.run.world.body(0).path().w.y() == Approx(0.25 * 12.5));
  ball.run.advance_to(until);
  end_rest_phase(ball.run, 0);
  const Event event = ball.last_event();
  CHECK(event.P_A_W.x() == Approx(-2));
  CHECK(event.P_A_W.z() == Approx(4));
}

TEST_CASE("rest event: a ball that spins too fast about the normal stops the run") {
  OnTable ball({7, 0, 0});
  RestCandidate candidate = ball.candidate();
  candidate.state.velocity.w_WB.z() = 0x1p13;
  REQUIRE(try_rest(ball.run, candidate, {7, 0, 0}, {}, 0));
  REQUIRE(ball.run.stopped());
  CHECK(ball.run.guard.stopped()->why == "turns too fast to be followed for a frame");
}

TEST_CASE("rest event: micro-bounces that remain are completed, with their impulse, when they end") {
  OnTable ball(still);
  // The first has 1/64 m/s, e = 0.5: they last 2v/(g (1 − e)) = 1/160 s with the mean force (1 + e)/2.
  REQUIRE(try_rest(ball.run, ball.candidate(), still, {1.0 / 64, 0.75}, 1.0 / 160));
  CHECK(ball.run.recorder.statistics().events() == 0);
  CHECK(ball.run.rests.of(0)->until == 1.0 / 160);
  ball.run.advance_to(1.0 / 160);
  end_rest_phase(ball.run, 0);
  CHECK(ball.run.rests.of(0)->until == never);
  const Event event = ball.last_event();
  CHECK(event.kind == Event::Kind::completed);
  CHECK(event.P_A_W.z() == Approx(10.0 / 160 - 1.0 / 64));  // of the weight, less what the bounce had
}

TEST_CASE("rest event: a ball that leaves the face is released, and flies") {
  OnTable ball({50, 0, 0});
  RestingContact rest;
  rest.on = 1;
  rest.nhat_W = up;
  rest.lever = -up;
  ball.run.rests.set(0, rest);
  ball.run.advance_to(0.5);
  end_rest_phase(ball.run, 0);
  CHECK(ball.run.rests.of(0) == nullptr);
  CHECK(ball.run.world.body(0).path().a == g_W);
  CHECK(ball.run.world.body(0).path().since == 0.5);
  CHECK(ball.last_event().kind == Event::Kind::release);
}

// Slip at 0.01 m/s ends at 0.01/(3.5 · 0.5 · 7.5) s, before the bounces of 1/160 s.
TEST_CASE("rest event: micro-bounces that something ends early are completed until then") {
  const auto bounces_under_way = [](OnTable& ball) {
    REQUIRE(try_rest(ball.run, ball.candidate(), {0.01, 0, 0}, {1.0 / 64, 0.75}, 1.0 / 160));
    CHECK(ball.run.recorder.statistics().events() == 0);
  };
  OnTable slips({0.01, 0, 0});
  bounces_under_way(slips);
  const double ends = slips.run.rests.of(0)->until;
  CHECK(ends == Approx(0.01 / 13.125));
  slips.run.advance_to(ends);
  end_rest_phase(slips.run, 0);
  CHECK(slips.run.rests.of(0)->bounces_end == 1.0 / 160);
  const Event event = slips.last_event();
  CHECK(event.kind == Event::Kind::completed);
  CHECK(event.P_A_W.z() == Approx(10 * ends - 1.0 / 64));
  OnTable released({0.01, 0, 0});
  bounces_under_way(released);
  released.run.advance_to(ends / 2);
  release_rest(released.run, 0, released.run.world.body(0).state(ends / 2));
  CHECK(released.run.recorder.statistics().of(Event::Kind::completed) == 1);
  CHECK(released.last_event().kind == Event::Kind::release);
}

// It falls 1 mm at 10 m/s², and leaves at 1/2 of its speed. Until the push there is its weight alone: the bounces gave
// g τ − v/2.
TEST_CASE("rest event: a force that begins during micro-bounces has no part in those before it") {
  const double v = std::sqrt(2 * 10 * 1e-3), pushed_at = 0.03;
  for (const double push : {-1000.0, 100.0}) {
    Scene scene = moving_scene({ball(1, 1.001 * up, still, {0.5, 0}), table()}, g_W, {0.2});
    scene.motion->envelope = 4e-4;
    scene.motion->force_bound = 1000;
    scene.motion->forces = {{pushed_at, 0, push * up}};
    const std::vector<Event> events = *simulate(scene).trajectory.events;
    const auto completed = std::ranges::find(events, Event::Kind::completed, &Event::kind);
    REQUIRE(completed != events.end());
    CHECK(completed->time == pushed_at);
    CHECK(completed->P_A_W.z() == Approx(10 * (pushed_at - v / 10) - v / 2));
  }
}

TEST_CASE("rest event: a pushed ball that reaches the edge of its table within rounding leaves it once") {
  for (int k = 0; k < 64; ++k) {
    const double side = 3 + k / 64.0;
    Scene scene = moving_scene({ball(0.25, {0, 0, 0.25}, still, {1, 0.125}), table(side)}, {0, 0, -9.75}, {1});
    scene.motion->force_bound = 128;
    scene.motion->forces = {{0, 0, {53, k % 2 == 0 ? -53.0 : 0.0, 0}}};
    INFO("half side " << side);
    const Simulated done = simulate(scene);
    INFO(done.trajectory.gave_up);
    CHECK(!done.stopped);
    CHECK(done.statistics.of(Event::Kind::release) < 8);
    CHECK(done.statistics.of(Event::Kind::contact) < 8);
  }
}

// It falls 1/2 m at 10 m/s² and bounces with e = 1/2 to the time of the end of all bounces, 3 √0.1 s. A frame ends a
// little before. Then the ball is at rest, and its rest is one in the next frame too.
TEST_CASE("rest event: bounces that end in a later frame than the last impact are an event") {
  const double ends = 3 * std::sqrt(0.1);
  const Scene scene = moving_scene({ball(1, 1.5 * up, still, {0.5, 0}), table()}, {0, 0, -10}, {1});
  for (const double after : {-0x1p-17, 0x1p-17}) {
    const Simulated done = simulate(scene, {.frame = ends + after});
    CHECK(done.statistics.of(Event::Kind::completed) == 1);
    const Event& last = done.trajectory.events->back();
    CHECK(last.kind == Event::Kind::completed);
    CHECK(last.time == Approx(ends).epsilon(1e-12));
  }
}

}  // namespace
}  // namespace touchstone::fast::simulation
