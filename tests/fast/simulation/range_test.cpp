// Which numbers a simulation in doubles refuses, and how far away positions stay resolved.
#include "fast/simulation/range.h"

#include "fast/simulation.h"
#include "fast/simulation/prediction/pair_time_of_impact.h"
#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

/// The place that is named, or "" if nothing is refused.
std::string refused(const Scene& scene) {
  std::vector<BodyMotion> bodies;
  for (const Body& body : scene.bodies) bodies.emplace_back(body, 0, scene.gravity);
  try {
    refuse_beyond_doubles(scene, bodies);
    return "";
  } catch (const BeyondDoubles& beyond) {
    return beyond.what();
  }
}

Scene plain() { return moving_scene({ball(1, {0, 0, 9}, {0, 0, -1}, {}), table()}, {0, 0, -10}, {1}); }

TEST_CASE("range: numbers below the limits pass") {
  Scene scene = plain();
  scene.bodies[0].velocity.v_WBcm = {0x1p249, 0, 0};
  scene.bodies[0].X_WB.p_WB = {0, -0x1p249, 0};
  CHECK(refused(scene).empty());
}

TEST_CASE("range: the first number beyond a limit is named") {
  const auto with = [](const auto& change) {
    Scene scene = plain();
    change(scene);
    return refused(scene);
  };
  CHECK_THAT(with([](Scene& s) { s.gravity.x() = 0x1p250; }), Catch::StartsWith("gravity"));
  CHECK_THAT(with([](Scene& s) { s.bodies[0].X_WB.p_WB.y() = -0x1p250; }), Catch::StartsWith("bodies[0].X_WB.p"));
  CHECK_THAT(with([](Scene& s) { s.bodies[0].velocity.v_WBcm.z() = 0x1p251; }),
             Catch::StartsWith("bodies[0].velocity"));
  CHECK_THAT(with([](Scene& s) { s.bodies[1].shape = Box{Vec3::Constant(0x1p-251)}; }),
             Catch::StartsWith("bodies[1].shape"));
  CHECK_THAT(with([](Scene& s) {
               s.bodies[0].mass = MassProperties{0x1p1001, Vec3::Zero(), Mat3::Identity()};
             }),
             Catch::StartsWith("bodies[0].mass"));
  CHECK_THAT(with([](Scene& s) {
               s.motion->forces = {{0, 0, {0x1p251, 0, 0}}};
             }),
             Catch::StartsWith("motion.forces[0]"));
}

TEST_CASE("range: positions are resolved while rounding stays below a thousandth of the smaller body") {
  // Rounding at a distance x is some 16u x = 2^-49 x, for a body of 1 m: too much from about 2^38 m on.
  const auto resolved_at = [](double x) {
    const Body near = ball(1, Vec3::Zero(), Vec3::Zero(), {}), far = ball(1, {x, 0, 0}, Vec3::Zero(), {});
    const BodyMotion a(near, 0, Vec3::Zero()), b(far, 0, Vec3::Zero());
    return positions_resolved(a, b, clearance(a, b, 0, never));
  };
  CHECK(resolved_at(1));
  CHECK(resolved_at(0x1p34));
  CHECK_FALSE(resolved_at(0x1p40));
}

}  // namespace
}  // namespace touchstone::fast::simulation
