// What a contact does, case by case, and the speeds that decide it.
#include "fast/simulation/response.h"

#include <cmath>

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double envelope = 0x1p-20;

Scene with_envelope(std::vector<Body> bodies, const Vec3& gravity) {
  Scene scene = moving_scene(std::move(bodies), gravity, {1});
  scene.motion->envelope = envelope;
  return scene;
}

TEST_CASE("response: every class of contact") {
  constexpr double bounce = 1, fast = 2.5, at_twice = 2, at_once = 1;
  struct Case {
    ContactSpeeds speeds;
    bool closed_form;
    Response response, with_micro_collisions;
  };
  constexpr Response later = Response::later, rest = Response::rest, join = Response::join_island,
                     micro = Response::micro_collision, impact = Response::impact;
  for (const Case& c : {
           // Two bodies in ballistic motion. A micro-bounce comes down as fast as it went up, up to rounding.
           Case{{-fast, bounce, false}, true, impact, impact},
           {{-fast, bounce, false}, false, impact, impact},
           {{-at_twice, bounce, false}, true, impact, impact},
           {{-at_twice, bounce, false}, false, join, micro},
           {{-at_once, bounce, false}, true, rest, rest},
           {{-at_once, bounce, false}, false, join, micro},
           {{0, bounce, false}, true, rest, rest},
           {{1.0 / 16, bounce, false}, true, rest, rest},
           {{0.07, bounce, false}, true, later, later},
           {{0.07, bounce, false}, false, later, later},
           // One of the two is in contact with something already.
           {{-fast, bounce, true}, true, impact, impact},
           {{-at_twice, bounce, true}, true, join, micro},
           {{0, bounce, true}, true, join, micro},
           {{32, bounce, true}, false, join, micro},
           {{33, bounce, true}, false, later, later},
           // Nothing presses the two together.
           {{-1e-9, 0, false}, true, impact, impact},
           {{0, 0, false}, true, later, later},
           {{1e-9, 0, false}, true, later, later},
           {{-1e-9, 0, true}, false, impact, impact},
       }) {
    CAPTURE(c.speeds.u_n, c.speeds.bounce_speed, c.speeds.in_contact, c.closed_form);
    CHECK(classify(c.speeds, c.closed_form, false) == c.response);
    CHECK(classify(c.speeds, c.closed_form, true) == c.with_micro_collisions);
  }
}

TEST_CASE("response: the rebound speed is that of a micro-bounce as high as the envelope") {
  const Scene scene = with_envelope({ball(1, {0, 0, 2}, Vec3::Zero(), {}), ball(1, {0, 0, 5}, Vec3::Zero(), {})}, g_W);
  const World world(scene);
  const Islands islands(world);
  CHECK(rebound_speed(world, islands, 0, 1) == Approx(std::sqrt(2 * 10 * envelope)));
}

TEST_CASE("response: without accelerations the rebound speed is what the contact solver can tell from rest") {
  Body spinning = ball(2, {0, 0, 2}, {3, 0, 4}, {0.5, 0});
  spinning.velocity.w_WB = {0, 6, 8};
  Scene scene = with_envelope({spinning, ball(1, {0, 0, 9}, {1, 0, 0}, {1, 0})}, Vec3::Zero());
  const World lossy(scene);
  CHECK(rebound_speed(lossy, Islands(lossy), 0, 1) == Approx(0x1p-40 * (5 + 2 * 10 + 1)));
  scene.bodies[0].material.restitution = 1;
  const World elastic(scene);
  CHECK(rebound_speed(elastic, Islands(elastic), 0, 1) == 0);
}

TEST_CASE("response: rotation presses a body with corners as the centripetal acceleration of its corners") {
  Body spinning = brick({1, 2, 2}, {0, 0, 9}, {});  // its corners are 3 m from its centre
  spinning.velocity.w_WB = {0, 2, 0};
  const Scene scene = with_envelope({spinning, ball(1, Vec3::Zero(), Vec3::Zero(), {})}, Vec3::Zero());
  const World world(scene);
  const Islands islands(world);
  CHECK(centripetal_bound(world, islands, 0, 1) == Approx(12));
  CHECK(rebound_speed(world, islands, 0, 1) == Approx(std::sqrt(2 * 12 * envelope)));
}

TEST_CASE("response: the bounce speed of a contact that begins follows from what presses along its normal") {
  const Scene scene = with_envelope({ball(1, {0, 0, 1}, Vec3::Zero(), {}), table()}, g_W);
  const World world(scene);
  const Islands islands(world);
  const Touch upright{0, Vec3::Zero(), {0, 0, 1}}, slope{0, Vec3::Zero(), {0.8, 0, 0.6}};
  CHECK(contact_speeds(world, islands, 0, 1, upright, -3, false).bounce_speed == Approx(std::sqrt(20 * envelope)));
  CHECK(contact_speeds(world, islands, 0, 1, slope, -3, false).bounce_speed == Approx(std::sqrt(12 * envelope)));
  CHECK(contact_speeds(world, islands, 0, 1, slope, -3, true).bounce_speed == Approx(std::sqrt(20 * envelope)));
  CHECK(contact_speeds(world, islands, 0, 1, slope, -3, true).u_n == -3);
  const Touch hanging{0, Vec3::Zero(), {0, 0, -1}};
  CHECK(contact_speeds(world, islands, 0, 1, hanging, -3, false).bounce_speed == 0);
}

}  // namespace
}  // namespace touchstone::fast::simulation
