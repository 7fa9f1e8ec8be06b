// Two bodies that start far from each other: the impact is at a time that the reference encloses, or the run stops.
#include <cmath>

#include "fast/simulation.h"
#include "fast/time_of_impact.h"
#include "model/limits.h"
#include "properties/cases/time_of_impact_case.h"
#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast {
namespace {

using Kind = Event::Kind;
using properties::MotionCase;

/// The second body starts at `way` and passes the first one at a distance of `beside`, halfway through a motion of 1 s.
Scene apart(Body first, Body second, const Vec3& way, const Vec3& beside, const Vec3& gravity = Vec3::Zero()) {
  second.X_WB.p_WB = way + beside;
  second.velocity.v_WBcm = -2 * way;
  return moving_scene({std::move(first), std::move(second)}, gravity, {1});
}

/// The impact must be in the reference's enclosure, widened by the envelope and by the rounding of the positions
/// (oracle::tolerance::moving_distance). If the rounding exceeds a thousandth of a body, the run may stop instead,
/// before the two touch.
void check_reported(const Scene& scene) {
  const MotionCase truth(scene, oracle::Precision::binary64);
  const auto near = oracle::truth::time_of_distance(scene, envelope(scene) + truth.slack);
  REQUIRE(truth.truth.status == TimeOfImpact::Status::hit);
  const Simulated done = simulate(scene);
  const std::vector<Event> impacts = of_kind(done, Kind::impact);
  if (done.stopped) {
    CHECK(!truth.sure());
    CHECK(impacts.empty());
    CHECK(done.stopped->time <= truth.truth.time.hi);
    CHECK(done.trajectory.gave_up.find("bodies[0] and bodies[1]") != std::string::npos);
    return;
  }
  REQUIRE(!impacts.empty());
  CHECK(near.time.lo <= impacts[0].time);
  CHECK(impacts[0].time <= truth.latest().value_or(truth.truth.time.hi));
}

TEST_CASE("two unit balls that close in at 8e8 m/s from 4e8 m meet after 0.4999999975 s") {
  const Scene scene = apart(ball(1, Vec3::Zero(), Vec3::Zero(), {1, 0}), ball(1, Vec3::Zero(), Vec3::Zero(), {1, 0}),
                            Vec3(4e8, 0, 0), Vec3::Zero());
  const Simulated done = simulate(scene);
  REQUIRE(done.trajectory.events->size() == 1);
  CHECK(std::abs(done.trajectory.events->front().time - 0.4999999975) < 1e-15);
  CHECK(!done.stopped);
}

TEST_CASE("two balls 2^4 to 2^60 radii apart are told to meet where the reference says, or the run stops before") {
  for (int k = 4; k <= 60; ++k) {
    const double far = std::ldexp(1, k);
    for (const double e : {1.0, 0.5}) {
      for (const Vec3& gravity : {Vec3(0, 0, 0), Vec3(0, 0, -8)}) {
        // |(3, 4, 12)| = 13, and (4, -3, 0) is orthogonal to it: all numbers are exact while a double holds 2^k + 1.
        for (const Vec3& way : {Vec3(1, 0, 0), Vec3(3, 4, 12)}) {
          for (const double beside : {0.0, 1.0}) {
            if (beside > 0 && k > 44) continue;
            INFO("2^" << k << " radii, e " << e << ", way " << way.transpose() << ", beside " << beside);
            const Body one = ball(13, Vec3::Zero(), Vec3::Zero(), {e, 0});
            const Vec3 across = way.z() > 0 ? Vec3(4, -3, 0) : Vec3(0, 5, 0);
            check_reported(apart(one, one, (way.z() > 0 ? 1 : 13) * far * way, beside * across, gravity));
          }
        }
      }
    }
  }
}

TEST_CASE("so are a ball and a wall, and two cubes") {
  for (int k = 4; k <= 60; k += 4) {
    INFO("2^" << k);
    const Vec3 way(std::ldexp(1, k), 0, 0);
    Body wall = brick(Vec3(1, 2, 3), Vec3::Zero(), {1, 0});
    wall.mass = Fixed{};
    const Body cube = brick(Vec3::Ones(), Vec3::Zero(), {1, 0});
    check_reported(apart(wall, ball(1, Vec3::Zero(), Vec3::Zero(), {1, 0}), way, Vec3(0, 0.5, 0)));
    check_reported(apart(cube, cube, way, Vec3(0, 0.5, 0)));
  }
}

// Halfway through, at 0.5 s, the computed position of the ball is the wall's. Its impact is 2^-60 s earlier.
TEST_CASE("a run that stops since positions are too coarse shows no state at that time") {
  Body wall = brick(Vec3(4, 2, 3), Vec3::Zero(), {0.5, 0.5});
  wall.mass = Fixed{};
  Scene scene = apart(wall, ball(3, Vec3::Zero(), Vec3::Zero(), {0.5, 0.5}), Vec3(0, 3 * 0x1p60, 0), Vec3(0.5, 0, 1));
  scene.motion->sample_times = {0.25, 0.5, 1};
  const Simulated done = simulate(scene);
  REQUIRE(done.stopped);
  CHECK(done.stopped->time == std::nextafter(0.5, 0.0));
  CHECK(done.trajectory.complete_until == done.stopped->time);
  CHECK(done.trajectory.states.size() == 1);
}

TEST_CASE("a ball that comes from far past another one misses it") {
  for (int k = 4; k <= 30; ++k) {
    INFO("2^" << k);
    const Body one = ball(1, Vec3::Zero(), Vec3::Zero(), {1, 0});
    const Simulated done = simulate(apart(one, one, Vec3(std::ldexp(1, k), 0, 0), Vec3(0, 2.0625, 0)));
    CHECK(done.trajectory.events->empty());
    CHECK(!done.stopped);
  }
}

TEST_CASE("a ball may be as slow as doubles allow") {
  for (const double speed : {1e-100, 1e-200, 1e-290}) {
    const Scene scene =
        moving_scene({ball(1, Vec3::Zero(), Vec3::Zero(), {1, 0}), ball(1, Vec3(4, 0, 0), Vec3(-speed, 0, 0), {1, 0})},
                     Vec3::Zero(), {4 / speed});
    INFO(speed << " m/s");
    const Simulated done = simulate(scene);
    const std::vector<Event> impacts = of_kind(done, Kind::impact);
    REQUIRE(impacts.size() == 1);
    CHECK(std::abs(impacts[0].time * speed - 2) < 0x1p-44);  // up to the distance that clearance() leaves: 272u
  }
}

TEST_CASE("numbers whose squares doubles cannot hold are refused by their place") {
  const Body one = ball(1, Vec3::Zero(), Vec3::Zero(), {1, 0});
  const auto said = [&](const auto& change) {
    Body other = ball(1, Vec3(4, 0, 0), Vec3(-1, 0, 0), {1, 0});
    Scene scene = moving_scene({one, other}, Vec3::Zero(), {4});
    change(scene);
    try {
      simulate(scene);
    } catch (const BeyondDoubles& beyond) {
      return std::string(beyond.what());
    }
    return std::string("not refused");
  };
  const auto begins = [](const std::string& text, const std::string& with) {
    INFO(text);
    CHECK(text.rfind(with + ": ", 0) == 0);
  };
  begins(said([](Scene& s) { s.bodies[1].velocity.v_WBcm.x() = -1e160; }), "bodies[1].velocity.v_WBcm");
  begins(said([](Scene& s) { s.bodies[1].velocity.w_WB.x() = 1e160; }), "bodies[1].velocity");
  begins(said([](Scene& s) { s.bodies[1].shape = Box{Vec3::Ones()}, s.bodies[1].velocity.w_WB.x() = 1e80; }),
         "bodies[1].velocity.w_WB");
  begins(said([](Scene& s) { s.bodies[1].X_WB.p_WB.x() = 1e160; }), "bodies[1].X_WB.p");
  begins(said([](Scene& s) { s.gravity.z() = -1e160; }), "gravity");
  begins(said([](Scene& s) { s.bodies[0].shape = Sphere{1e-110}; }), "bodies[0].shape");
  begins(said([](Scene& s) { s.bodies[1].mass = Density{1e-310}; }), "bodies[1].mass");
  begins(said([](Scene& s) {
           s.bodies[0].shape = s.bodies[1].shape = Sphere{1e-70};  // the moment of inertia is 1e-350 kg m²
           s.bodies[0].mass = s.bodies[1].mass = Density{1};
         }),
         "bodies[0].mass");
  begins(said([](Scene& s) {
           s.bodies[0].shape = s.bodies[1].shape = Sphere{1e-110};
           s.bodies[0].mass = s.bodies[1].mass = Density{1};
         }),
         "bodies[0].shape");
  begins(said([](Scene& s) {
           s.motion->force_bound = 1e160;
           s.motion->forces.push_back({1, 1, Vec3(1e160, 0, 0)});
         }),
         "motion.forces[0].force_W");
}

}  // namespace
}  // namespace touchstone::fast
