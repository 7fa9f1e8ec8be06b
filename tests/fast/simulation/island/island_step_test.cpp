// Steps whose result is known: free fall, rest on a table, and a fall that ends where the ball comes down.
#include "fast/simulation/island/island_step.h"

#include "tests/catch.h"
#include "tests/fast/simulation/island/island_bodies.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("island step: the length is a part of the time in which a body falls or moves by its size, or turns") {
  Body body = ball(1, {0, 0, 9}, {3, 0, 4}, {});
  body.velocity.w_WB = {0, 2, 0};
  // Rates: |w| = 2, |v|/size = 5, sqrt(|a|/size) = 3; the table does not count.
  const IslandBodies bodies({body, table()}, {0, 0, -9});
  const ContactGraph graph = bodies.graph(near, reach);
  CHECK(step_length(graph, 32, 100) == Approx(1.0 / 320));
  CHECK(step_length(graph, 32, 0.001) == 0.001);
}

TEST_CASE("island step: without contacts the step is a parabola") {
  const IslandBodies bodies({ball(1, {0, 0, 9}, {2, 0, 0}, {})}, g_W);
  const ContactGraph graph = bodies.graph(near, reach);
  const StepPlan plan = solve_step(graph, 0.5, 0.5);
  CHECK(plan.h == 0.5);
  CHECK(plan.stepped.after[0].X_WB.p_WB.x() == Approx(1));
  CHECK(plan.stepped.after[0].X_WB.p_WB.z() == Approx(9 - 1.25));
  CHECK(plan.stepped.after[0].velocity.v_WBcm.z() == Approx(-5));
  CHECK(plan_step(graph, 0.5, 0.5).h == 0.5);
}

TEST_CASE("island step: a ball that lies on a table stays there, and its contact carries its weight") {
  const IslandBodies bodies({ball(1, {0, 0, 1}, still, {}, 2), table()}, g_W);
  const ContactGraph graph = bodies.graph(near, reach);
  CHECK(constraints(graph).size() == 1);
  CHECK(step_bodies(graph).size() == 2);
  const StepPlan plan = plan_step(graph, 0.125, 0.125);
  CHECK(plan.h == 0.125);
  CHECK(plan.stepped.after[0].X_WB.p_WB.z() == Approx(1));
  CHECK(plan.stepped.after[0].velocity.v_WBcm.norm() < 2 * near / 1024 / 0.125);
  REQUIRE(plan.constraints.size() == 1);
  CHECK(plan.constraints[0].contact_point.F_A_W.z() > 0);
  CHECK(deepest(graph, plan) <= near / 1024);
}

TEST_CASE("island step: a residual may be size/steps^3, or what counts as touching, and what rounding adds") {
  const IslandBodies bodies({ball(1, {0, 0, 1}, still, {}), ball(0.5, {0, 3, 0.5}, still, {}), table()}, g_W);
  const ContactGraph graph = bodies.graph(0x1p-30, reach);
  CHECK(accuracy(graph) == 0x1p-40);
  CHECK(residual_bound(graph, 32) ==
        Approx(0.5 / 32768).epsilon(1e-6));  // the smaller ball's; the table does not count
  CHECK(residual_bound(graph, 1e6) == Approx(0x1p-30).epsilon(0.01));
  const IslandBodies far({ball(1, {0x1p30, 0, 1}, still, {})}, g_W);
  CHECK(residual_bound(far.graph(0x1p-30, reach), 1e6) == Approx(0x1p-16).epsilon(1e-3));
}

TEST_CASE("island step: a step ends where a ball that did not touch comes down") {
  const IslandBodies bodies({ball(1, {0, 0, 1.0625}, {0, 0, -1}, {}), table()}, still);
  const ContactGraph graph = bodies.graph(near, reach);
  REQUIRE(graph.contact_pairs().size() == 1);
  const StepPlan plan = plan_step(graph, 0.125, 0.125);
  const double gap = 0.0625 - plan.h;
  CHECK(gap >= 0);
  CHECK(gap <= near / 4);
  CHECK(deepest(graph, plan) == 0);
}

TEST_CASE("island step: it ends where a ball comes down that falls ever faster, wherever in the step that is") {
  for (const double height : {0x1p-10, 0x1p-7, 0x1p-4}) {
    const IslandBodies bodies({ball(1, {0, 0, 1 + near + height}, still, {}), table()}, g_W);
    const ContactGraph graph = bodies.graph(near, reach);
    const StepPlan plan = plan_step(graph, 0.125, 0.125);
    const double gap = near + height - 5 * plan.h * plan.h;
    CHECK(gap >= 0);
    CHECK(gap <= near / 2);
  }
}

// The ball is over the table's side after 1/16 s; then it is on the edge, d beyond it at a height of √(1 − d²) − 1.
TEST_CASE("island step: a step ends where a ball slides off the table, and not at its end in the air") {
  const IslandBodies bodies({ball(1, {3.9375, 0, 1}, {1, 0, 0}, {}), table(4)}, g_W);
  const ContactGraph graph = bodies.graph(0x1p-30, reach);
  const StepPlan plan = plan_step(graph, 0.125, 0.125);
  CHECK(solve_step(graph, 0.125, 0.125).h == 0.125);
  CHECK(plan.h >= 0.0625);
  CHECK(plan.h < 0.0627);
  CHECK(plan_step(graph, 0.0625, 0.125).h == 0.0625);
}

// μ g = 2.5: slip of 0.25 m/s at the contact point falls at 7/2 of that, and ends after 0.25/8.75 s.
TEST_CASE(
    "island step: a step ends where the slip of a ball does, and so does that of a second one, but not of a third") {
  const auto planned = [](int count) {
    std::vector<Body> bodies;
    for (int i = 0; i < count; ++i) bodies.push_back(ball(1, {4.0 * i - 4, 0, 1}, {0.25, 0, 0}, {0, 0.25}));
    bodies.push_back(table());
    return plan_step(IslandBodies(bodies, g_W).graph(0x1p-30, reach), 0.0625, 0.0625);
  };
  CHECK(planned(1).h == Approx(0.25 / 8.75).epsilon(1e-6));
  CHECK(planned(2).h == Approx(0.25 / 8.75).epsilon(1e-6));
  CHECK(planned(3).h == 0.0625);
  CHECK(planned(1).stepped.after[0].velocity.w_WB.y() == Approx(0.25 * 5 / 7));
}

// At the end of the whole step the ball is 0.04 − 0.25 + 5/16 = 0.1 m above the table.
TEST_CASE("island step: it ends where a ball comes down, although it would be lifted again before the end") {
  const IslandBodies bodies({ball(1, {0, 0, 1.04}, {0, 0, -1}, {}), table()}, -g_W);
  const ContactGraph graph = bodies.graph(near, reach);
  REQUIRE(graph.contact_pairs().size() == 1);
  const StepPlan plan = plan_step(graph, 0.25, 0.25);
  const double gap = 0.04 - plan.h + 5 * plan.h * plan.h;
  CHECK(plan.h < 0.1);  // where it would be lowest
  CHECK(gap >= 0);
  CHECK(gap <= near / 2);
}

// Weight carried by the table: it may vanish or double, and friction may change from one direction to the other.
TEST_CASE("island step: forces may change by twice themselves, and by friction's") {
  Body rough = ball(1, {0, 0, 1}, still, {}, 2);
  rough.material.friction = 0.5;
  Body below = table();
  below.material.friction = 0.5;
  const IslandBodies bodies({rough, below}, g_W);
  const ContactGraph graph = bodies.graph(near, reach);
  CHECK(deviation(graph, solve_step(graph, 0.125, 0.125)).acceleration == Approx(2 * 1.5 * 10));
}

TEST_CASE("island step: how deep two bodies are at its end") {
  const IslandBodies bodies({ball(1, {0, 0, 1.0625}, {0, 0, -1}, {}), table()}, still);
  const ContactGraph graph = bodies.graph(near, reach);
  CHECK(deepest(graph, solve_step(graph, 0.125, 0.125)) == Approx(0.0625));
}

TEST_CASE("island step: the deviation is a quarter of what the velocity changes in the step") {
  const IslandBodies falls({ball(1, {0, 0, 9}, still, {})}, g_W);
  const ContactGraph graph = falls.graph(near, reach);
  CHECK(deviation(graph, solve_step(graph, 0.5, 0.5)).margin == Approx(0.5 * 5 / 4));
  // A box of radius 3 that turns by 0.5 rad: an eighth of its cube for each metre.
  Body box = brick({1, 2, 2}, {0, 0, 9}, {});
  box.velocity.w_WB = {1, 0, 0};
  const IslandBodies turns({box}, still);
  const ContactGraph turning = turns.graph(near, reach);
  CHECK(deviation(turning, solve_step(turning, 0.5, 0.5)).margin == Approx(3 * 0.125 / 8).epsilon(1e-6));
}

}  // namespace
}  // namespace touchstone::fast::simulation
