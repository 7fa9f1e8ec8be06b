// Impacts of balls on a line, on paper.
#include "properties/cases/simultaneous_impacts.h"

#include "tests/catch.h"

namespace touchstone::properties {
namespace {

/// Balls of radius 1 and their velocities along x, which meet at the time 0.
Scene row(const std::vector<double>& places, const std::vector<double>& speeds) {
  Scene scene;
  for (std::size_t i = 0; i < places.size(); ++i) {
    Body& ball = scene.bodies.emplace_back();
    ball.shape = Sphere{1};
    ball.mass = MassProperties{1, Vec3::Zero(), Mat3::Identity()};
    ball.X_WB.p_WB.x() = places[i];
    ball.velocity.v_WBcm.x() = speeds[i];
  }
  scene.motion = Motion{.sample_times = {1}};
  return scene;
}

/// An impact of two neighbours, after which they have these speeds.
Event impact(const Scene& scene, int a, double speed_a, double speed_b) {
  Event event;
  event.kind = Event::Kind::impact;
  event.a = a;
  event.b = a + 1;
  event.nhat_BA_W = -Vec3::UnitX();
  const auto after = [&](int body, double speed) {
    return State{scene.bodies[static_cast<std::size_t>(body)].X_WB, {Vec3(speed, 0, 0), Vec3::Zero()}};
  };
  event.after_a = after(a, speed_a);
  event.after_b = after(a + 1, speed_b);
  event.p_WC = event.after_a.X_WB.p_WB + Vec3::UnitX();
  return event;
}

std::vector<bool> together(const Scene& scene, const std::vector<Event>& events) {
  Trajectory said;
  said.events = events;
  const std::optional<oracle::Stepping> stepping;
  const oracle::DistanceTolerance distances;
  const oracle::Dynamics dynamics;
  const TrajectoryCase asked{scene, oracle::Precision::binary64, said, 1, stepping, distances, dynamics};
  const Timeline segments = timeline(scene, said);
  SimultaneousImpacts simultaneous(asked, segments);
  std::vector<bool> all;
  for (const Event& event : *said.events) all.push_back(simultaneous.act_together_with(event));
  return all;
}

TEST_CASE("simultaneous impacts: a ball that is hit from both sides at one time") {
  const Scene scene = row({0, 2, 4}, {1, 0, -1});
  CHECK(together(scene, {impact(scene, 0, 0, 1), impact(scene, 1, -1, 1)}) == std::vector<bool>{true, true});
}

TEST_CASE("simultaneous impacts: what is passed on through a row comes one after the other") {
  const Scene scene = row({0, 2, 4}, {1, 0, 0});
  CHECK(together(scene, {impact(scene, 0, 0, 1), impact(scene, 1, 0, 1)}) == std::vector<bool>{false, false});
}

TEST_CASE("simultaneous impacts: pairs that share no ball, and impacts of a fixed ball's two sides") {
  const Scene apart = row({0, 2, 4, 6}, {1, 0, 1, 0});
  CHECK(together(apart, {impact(apart, 0, 0, 1), impact(apart, 2, 0, 1)}) == std::vector<bool>{false, false});
  Scene between = row({0, 2, 4}, {1, 0, -1});
  between.bodies[1].mass = Fixed{};
  CHECK(together(between, {impact(between, 0, -1, 0), impact(between, 1, 0, 1)}) == std::vector<bool>{false, false});
}

// The right body turns, so its upper ball separates before the impacts, and the impulse on the lower one presses it
// down.
TEST_CASE("simultaneous impacts: two parts of a body, of which one separates before") {
  Scene scene = row({0, 2}, {1, 0});
  const Part lower{{}, Sphere{1}}, upper{{{0, 3, 0}, {}}, Sphere{1}};
  scene.bodies[1].shape = Compound{{lower, upper}};
  scene.bodies[1].velocity.w_WB.z() = -1;
  std::vector<Event> events = {impact(scene, 0, 0, 0.5), impact(scene, 0, -1, 1.5)};
  events[1].p_WC.y() = 3;
  CHECK(together(scene, events) == std::vector<bool>{true, true});
  scene.bodies[1].shape = Sphere{1};  // of two convex bodies all points are one region
  CHECK(together(scene, events) == std::vector<bool>{false, false});
}

TEST_CASE("simultaneous impacts: of a row that comes to rest, those that were approaching from the start") {
  const Scene scene = row({0, 2, 4}, {1, 0, -1});
  std::vector<Event> events = {impact(scene, 0, 0.25, 0.75), impact(scene, 1, -0.5, 0.25)};
  for (int round = 0; round < 3; ++round) {
    events.push_back(impact(scene, 0, 0, -0.25));
    events.push_back(impact(scene, 1, 0, 0.25));
  }
  const std::vector<bool> all = together(scene, events);
  CHECK(all[0]);
  CHECK(all[1]);
  // The right contact approaches before the first impact, as the left one does; the left one never again with it.
  CHECK(all == std::vector<bool>{true, true, false, true, false, true, false, true});
}

TEST_CASE("simultaneous impacts: what contacts that come again did at a later event is not mixed up with the first") {
  // The impact of balls 3 and 4 comes first and touches none of the others.
  const Scene scene = row({0, 2, 4, 10, 12}, {1, 0, -1, 1, 0});
  std::vector<Event> events = {impact(scene, 3, 0, 1), impact(scene, 0, 0.25, 0.75), impact(scene, 1, -0.5, 0.25)};
  for (int round = 0; round < 2; ++round) {
    events.push_back(impact(scene, 0, 0, -0.25));
    events.push_back(impact(scene, 1, 0, 0.25));
  }
  CHECK(together(scene, events) == std::vector<bool>{false, true, true, false, true, false, true});
}

// The box turns, so beside C it approaches the bar's end. By its tilt none of its vertices is near the plane of
// contact.
TEST_CASE("simultaneous impacts: a region that approaches beside C, on a face that tilts") {
  Scene scene = row({-2, 0, 2}, {1, -0x1p-10, 0});
  scene.bodies[1].shape = Box{Vec3(1, 1, 1)};
  scene.bodies[1].X_WB.q_WB = {1, 0, 0, 0x1p-32};
  scene.bodies[1].velocity.w_WB.z() = -1;
  scene.bodies[2].shape = Box{Vec3(1, 0x1p-9, 0x1p-9)};
  const auto both = [&] { return together(scene, {impact(scene, 0, 0, 1), impact(scene, 1, 0, 1)}); };
  CHECK(both() == std::vector<bool>{true, true});
  scene.bodies[1].velocity.w_WB.z() = -0x1p-3;  // the bar is too thin for it to approach
  CHECK(both() == std::vector<bool>{false, false});
}

}  // namespace
}  // namespace touchstone::properties
