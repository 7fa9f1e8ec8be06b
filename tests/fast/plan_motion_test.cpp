// Omitted queries change no answer of the simulation, and how many are omitted.
#include <algorithm>

#include "app/motion/motion_scenes.h"
#include "fast/plan.h"
#include "fast/simulation.h"
#include "tests/catch.h"

namespace touchstone::fast {
namespace {

Scene named(const std::string& name) {
  const auto& all = app::motion_scenes();
  return std::ranges::find_if(all, [&](const app::MotionScene& motion) { return motion.scene.name == name; })->scene;
}

Plan plan_of(const Scene& scene) {
  Plan plan;
  plan_motion(scene, plan);
  return plan;
}

const std::string* why(const std::vector<Choice>& choices, const std::string& what) {
  const auto found = std::ranges::find_if(choices, [&](const Choice& choice) { return choice.what == what; });
  return found == choices.end() ? nullptr : &found->why;
}

TEST_CASE("plan of a flight: counts pairs and bodies") {
  const Plan gas = plan_of(named("gas"));  // 64 balls and six walls: 64·63/2 + 64·6 pairs
  REQUIRE(why(gas.used, "times of impact in closed form") != nullptr);
  CHECK(why(gas.used, "times of impact in closed form")->starts_with("2400 pairs "));
  CHECK(why(gas.left_out, "pairs of fixed bodies")->starts_with("15 pairs"));
  CHECK(why(gas.left_out, "all pairs")->starts_with("2400 pairs "));
  CHECK(why(gas.left_out, "later frames")->starts_with("6 bodies "));
  CHECK(why(gas.left_out, "orientation of balls")->starts_with("64 balls"));
  CHECK(why(gas.used, "conservative advancement") == nullptr);
  CHECK(why(gas.used, "contact mode") == nullptr);  // no gravity
  CHECK(why(gas.left_out, "contact mode")->starts_with("2400 pairs "));

  const Plan polytopes = plan_of(named("polytopes"));  // 8 and six walls
  CHECK(why(polytopes.used, "conservative advancement")->starts_with("76 pairs "));
  CHECK(why(polytopes.used, "Euler's equations")->starts_with("8 bodies "));

  const Plan top = plan_of(named("top_middle_axis"));
  CHECK(why(top.used, "Euler's equations")->starts_with("1 body "));
  CHECK(why(top.left_out, "all pairs") == nullptr);

  const Plan stack = plan_of(named("stack_1_to_100"));
  CHECK(why(stack.left_out, "Euler's equations")->starts_with("2 bodies "));
  CHECK(why(stack.used, "contact mode")->starts_with("3 pairs "));
  CHECK(why(stack.left_out, "contact mode") == nullptr);
}

TEST_CASE("plan of a flight: a push lets bodies stay in contact as gravity does") {
  Scene scene = named("gas");
  scene.motion->force_bound = 1;
  scene.motion->forces = {{0.5, 0, Vec3(1, 0, 0)}};
  CHECK(why(plan_of(scene).used, "contact mode")->starts_with("2400 pairs "));
}

/// One frame, so that the boxes over it cover the whole trajectories: all pairs that could ever touch are queried.
Simulated all_asked(const Scene& scene) { return simulate(scene, {.frame = scene.motion->sample_times.back()}); }

TEST_CASE("plan of a flight: with all pairs asked no state and no event changes a bit") {
  for (const std::string name : {"gas", "balls_49", "pool_break", "rough_ball", "newtons_cradle"}) {
    CAPTURE(name);
    const Scene scene = named(name);
    const Trajectory few = simulate(scene).trajectory, all = all_asked(scene).trajectory;
    CHECK(few.states == all.states);
    CHECK(few.events == all.events);
  }
}

TEST_CASE("plan of a flight: in a crowd most questions are saved") {
  const Scene scene = named("gas");
  CHECK(8 * simulate(scene).statistics.pairs < all_asked(scene).statistics.pairs);
}

}  // namespace
}  // namespace touchstone::fast
