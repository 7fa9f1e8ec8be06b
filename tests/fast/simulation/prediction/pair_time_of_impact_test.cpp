// First contacts by hand: of balls, of a ball and a block, and of other bodies.
#include "fast/simulation/prediction/pair_time_of_impact.h"

#include <cmath>

#include "fast/distance.h"
#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double envelope = 0x1p-30;

struct Two {
  Two(Body first, Body second, const Vec3& gravity = g_W)
      : body_a(std::move(first)), body_b(std::move(second)), a(body_a, 0, gravity), b(body_b, 0, gravity) {}

  double first_contact(double until = 10) {
    return simulation::first_contact(a, b, 0, until, envelope, Deviation{}, memory);
  }
  Touch touch(double t) { return simulation::touch(a, b, t, memory); }

  Body body_a, body_b;
  BodyMotion a, b;
  PairMemory memory;
};

TEST_CASE("pair time of impact: equally accelerated balls meet as if there were no gravity") {
  Two head_on(ball(1, {-3, 0, 0}, {1, 0, 0}, {}), ball(1, {3, 0, 0}, {-1, 0, 0}, {}));
  CHECK(has_closed_form(head_on.a, head_on.b));
  const double t = head_on.first_contact();
  CHECK(t == Approx(2));
  CHECK(t <= 2);  // never overlapping: the clearance is a few roundings
  const Touch touch = head_on.touch(t);
  CHECK(touch.gap >= 0);
  CHECK(touch.gap < 1e-12);
  CHECK(touch.nhat_BA_W == Vec3(-1, 0, 0));
  CHECK(touch.p_WC.x() == Approx(0).margin(1e-13));
  CHECK(head_on.first_contact(1.5) == never);
  // 3-4-5: the centres pass at 1.2, of 2 radii: contact where they are 1.6 apart along x.
  CHECK(Two(ball(1, {-4, 1.2, 0}, {1, 0, 0}, {}), ball(1, still, still, {})).first_contact() == Approx(2.4));
  CHECK(Two(ball(1, {-4, 2.1, 0}, {1, 0, 0}, {}), ball(1, still, still, {})).first_contact() == never);
  CHECK(Two(ball(1, {-4, 0, 0}, {-1, 0, 0}, {}), ball(1, still, still, {})).first_contact() == never);
}

TEST_CASE("pair time of impact: a ball falls onto a face, past an edge, and onto an edge") {
  CHECK(Two(ball(1, {0, 0, 6}, still, {}), table()).first_contact() == Approx(1));  // 5 m at 10 m/s²
  CHECK(Two(table(), ball(1, {0, 0, 6}, still, {})).first_contact() == Approx(1));
  CHECK(Two(ball(1, {0, 0, 6}, still, {}), table()).first_contact(0.75) == never);
  CHECK(Two(ball(1, {102, 0, 6}, still, {}), table()).first_contact() == never);
  // Beside the edge by 0.6: its lowest point for contact is 0.8 above the face.
  CHECK(Two(ball(1, {100.6, 0, 0.8 + 5}, still, {}), table()).first_contact() == Approx(1));
}

TEST_CASE("pair time of impact: the depth of a ball whose centre is inside a block is that to the nearest face") {
  const Touch touch = Two(ball(1, {0, 0, -0.25}, still, {}), table()).touch(0);
  CHECK(touch.gap == -1.25);
  CHECK(touch.nhat_BA_W == Vec3(0, 0, 1));
}

TEST_CASE("pair time of impact: other bodies are found within the envelope, before they touch") {
  Two boxes(brick({1, 1, 1}, {-3, 0, 0}, {}), brick({1, 1, 1}, {3, 0.5, 0}, {}));
  boxes.a.restart(0, {boxes.body_a.X_WB, {{2, 0, 0}, still}}, g_W);
  CHECK_FALSE(has_closed_form(boxes.a, boxes.b));
  const double t = boxes.first_contact();
  CHECK(t <= 2);
  CHECK(2 - t <= envelope / 2 * 1.001);  // 2 m/s through the envelope
  const Touch touch = boxes.touch(t);
  CHECK(touch.nhat_BA_W.x() == Approx(-1));
  CHECK(touch.p_WC.x() == Approx(2));
  CHECK(boxes.memory.queries > 0);
}

TEST_CASE("pair time of impact: a search that takes more queries than allowed tells so, and where it ended") {
  Two boxes(brick({1, 0.5, 0.75}, {0, 0, 0}, {}), brick({1, 1, 1}, {3, 0, 0}, {}));
  boxes.a.restart(0, {boxes.body_a.X_WB, {{0.5, 0, 0}, {0, 0x1p63, 0.25}}}, g_W);
  const double t = boxes.first_contact(2);
  CHECK(boxes.memory.is_cut_off);
  CHECK(t >= 0);
  CHECK(t <= 2);  // they touch by then, however the box turns
}

TEST_CASE("pair time of impact: inflation makes contacts earlier by its margin") {
  Two two(ball(1, {-3, 0, 0}, {1, 0, 0}, {}), ball(1, {3, 0, 0}, {-1, 0, 0}, {}));
  const Deviation half{{0, 0.5, 0}};
  CHECK(first_contact(two.a, two.b, 0, 10, envelope, half, two.memory) == Approx(1.75));
}

// They are 0.25 m apart and separate at 2 m/s. Where trajectories are off by up to 4 t²/2, they may touch when
// 0.25 + 2 t = 2 t², at t = (1 + √1.5)/2.
TEST_CASE("pair time of impact: balls that separate within the inflation may touch when the deviation has grown") {
  Two two(ball(1, {-1.125, 0, 0}, {-1, 0, 0}, {}), ball(1, {1.125, 0, 0}, {1, 0, 0}, {}), still);
  const Deviation deviation{{0, 0.5, 0}, 0, 4};
  CHECK(first_contact(two.a, two.b, 0, 10, envelope, deviation, two.memory) == Approx((1 + std::sqrt(1.5)) / 2));
  two.a.restart(0, {two.body_a.X_WB, {{1, 0, 0}, still}}, still);
  CHECK(first_contact(two.a, two.b, 0, 10, envelope, deviation, two.memory) == 0);  // they do not separate
}

TEST_CASE("pair time of impact: the clearance is a power of two above rounding, and at most half the envelope") {
  const Two two(ball(1, {-3, 0, 0}, {1, 0, 0}, {}), ball(1, {3, 0, 0}, {-1, 0, 0}, {}), still);
  const double clear = clearance(two.a, two.b, 1, never);
  int exponent = 0;
  CHECK(std::frexp(clear, &exponent) == 0.5);
  CHECK(clear >= 16 * 0x1p-53 * 8);  // 16u of the positions and radii, 3 + 1 m each
  CHECK(clear < 1e-13);
  CHECK(clearance(two.a, two.b, 1, 1e-20) == 0.5e-20);
}

// A needle that has turned by 400 rad: its pose is claimed to 8e-12 m at its ends, an envelope is 2e-12 m.
TEST_CASE("pair time of impact: bodies are within the envelope where claimed errors hide a wider gap") {
  constexpr double thin = 0x1p-9, near = 0x1p-30 * thin;
  Body needle = brick({1, thin, thin}, {0, 0, 0.75}, {});
  needle.velocity.w_WB = {1000, 0.5, 0.25};
  for (int i = 0; i < 8; ++i) {
    needle.velocity.v_WBcm = {0, 0, 0.03125 * i};
    Two two(needle, table());
    const double t = first_contact(two.a, two.b, 0, 2, near, Deviation{}, two.memory);
    REQUIRE(t < 2);
    Scene there;
    there.bodies = {two.body_a, two.body_b};
    there.bodies[0].X_WB = two.a.ballistic().pose(t);
    const Distance apart = fast::distance(there);
    CHECK(apart.verdict == Verdict::separated);
    CHECK(*apart.distance <= near);
    const Touch touch = two.touch(t);
    CHECK(touch.p_WC.z() >= -near);
    CHECK(touch.p_WC.z() <= near);
  }
}

}  // namespace
}  // namespace touchstone::fast::simulation
