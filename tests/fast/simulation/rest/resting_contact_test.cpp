// Rest, slip and rolling on a face, by the formulas of a textbook.
#include "fast/simulation/rest/resting_contact.h"

#include <cmath>

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

std::optional<RestingContact> on_table(const Body& body, const Vec3& gravity, double friction, double half_side = 100) {
  const Body support = table(half_side);
  return ball_on_face(BodyMotion(body, 0, gravity), BodyMotion(support, 0, still), {body.X_WB, body.velocity}, 0, up,
                      gravity, friction);
}

TEST_CASE("resting contact: a micro-bounce of that speed is as high as the envelope") {
  const double v = micro_bounce_speed(10, 0.05);
  CHECK(v * v / (2 * 10) == Approx(0.05));
  CHECK(micro_bounce_speed(0, 0.05) == 0);
  CHECK(micro_bounce_speed(-1, 0.05) == 0);
}

TEST_CASE("resting contact: a ball slides until it rolls, after 2v/(7 μ g)") {
  const auto rest = on_table(ball(1, {0, 0, 1}, {7, 0, 0}, {}), g_W, 0.5);
  REQUIRE(rest.has_value());
  CHECK(rest->acceleration.x() == Approx(-5));
  CHECK(rest->alpha.y() == Approx(12.5));  // μ m g r / (2/5 m r²)
  CHECK(rest->until == Approx(0.4));
  CHECK(rest->ends_by == RestingContact::End::slip_ends);
  CHECK(rest->lever == Vec3(0, 0, -1));
}

TEST_CASE("resting contact: a ball rolls down a slope with 5/7 of what pulls it, if friction suffices") {
  // Gravity along the face is 2, against it 10: rolling needs μ ≥ 2/7 · 2/10.
  const Vec3 slope(2, 0, -10);
  const auto rolls = on_table(ball(1, {0, 0, 1}, still, {}), slope, 0.06);
  REQUIRE(rolls.has_value());
  CHECK(rolls->acceleration.x() == Approx(10.0 / 7));
  CHECK(rolls->alpha.y() == Approx(10.0 / 7));
  CHECK(rolls->ends_by == RestingContact::End::leaves);
  CHECK(rolls->until == Approx(std::sqrt(2 * 100 / (10.0 / 7))));  // the side of the face is 100 m away
  const auto slides = on_table(ball(1, {0, 0, 1}, still, {}), slope, 0.05);
  REQUIRE(slides.has_value());
  CHECK(slides->acceleration.x() == Approx(2 - 0.5));
}

TEST_CASE("resting contact: slip across the slope, and contact at an edge, have no closed form") {
  CHECK_FALSE(on_table(ball(1, {0, 0, 1}, {0, 3, 0}, {}), {2, 0, -10}, 0.5).has_value());
  CHECK_FALSE(on_table(ball(1, {2.5, 0, 1}, still, {}), g_W, 0.5, 2).has_value());
}

TEST_CASE("resting contact: a block lies, slides until it stops, or tips") {
  const Body support = table();
  const auto rest = [&](const Vec3& half, const Vec3& v, const Vec3& gravity, double friction, double load = 1) {
    const Body block = brick(half, {0, 0, half.z()}, {});
    const std::vector<Vec3> corners = {
        {half.x(), half.y(), 0}, {-half.x(), half.y(), 0}, {-half.x(), -half.y(), 0}, {half.x(), -half.y(), 0}};
    return body_on_face(BodyMotion(block, 0, gravity), BodyMotion(support, 0, still), {block.X_WB, {v, still}}, 0, up,
                        corners, gravity, friction, 1e-3, load);
  };
  const auto lies = rest({1, 1, 1}, {1e-4, 0, 0}, g_W, 0.5);
  REQUIRE(lies.has_value());
  CHECK(lies->start.velocity.v_WBcm == still);
  CHECK(lies->acceleration == still);
  const auto on_ice = rest({1, 1, 1}, {1e-4, 0, 0}, g_W, 0);
  REQUIRE(on_ice.has_value());
  CHECK(on_ice->start.velocity.v_WBcm == Vec3(1e-4, 0, 0));
  CHECK(on_ice->acceleration == still);
  const auto slides = rest({1, 1, 1}, {3, 0, 0}, g_W, 0.5);
  REQUIRE(slides.has_value());
  CHECK(slides->acceleration.x() == Approx(-5));
  CHECK(slides->until == Approx(0.6));
  CHECK(slides->ends_by == RestingContact::End::slip_ends);
  const auto bounces = rest({1, 1, 1}, {3, 0, 0}, g_W, 0.5, 0.75);
  REQUIRE(bounces.has_value());
  CHECK(bounces->acceleration.x() == Approx(-3.75));
  CHECK(bounces->until == Approx(0.8));
  CHECK(bounces->lever == slides->lever);
  CHECK_FALSE(rest({1, 1, 4}, {3, 0, 0}, g_W, 0.5).has_value());  // the force would act 2 m in front of the centre
  CHECK_FALSE(rest({1, 1, 1}, {0, 0, 0.1}, g_W, 0.5).has_value());
  CHECK_FALSE(rest({1, 1, 1}, {0, 3, 0}, {6, 0, -10}, 0.5).has_value());
}

TEST_CASE("resting contact: what remains of a velocity at the end of slip, and without its normal part") {
  const Body body = ball(2, {0, 0, 2}, {3, 0, -1}, {}), support = table();
  const BodyMotion moving(body, 0, g_W), on(support, 0, still);
  const State state{body.X_WB, body.velocity};
  CHECK(without_normal(on, state, up).velocity.v_WBcm == Vec3(3, 0, 0));
  const State rolls = without_slip(moving, on, without_normal(on, state, up), up);
  CHECK((rolls.velocity.v_WBcm - Vec3(15.0 / 7, 0, 0)).norm() < 1e-15);  // m v r + I ω about the contact point is kept
  CHECK((rolls.velocity.w_WB - Vec3(0, 15.0 / 14, 0)).norm() < 1e-15);
  const Body block = brick({1, 1, 1}, {0, 0, 1}, {});
  CHECK(without_slip(BodyMotion(block, 0, g_W), on, {block.X_WB, {{1, 0, 0}, still}}, up).velocity.v_WBcm == still);
}

TEST_CASE("resting contact: a normal that is off by rounding becomes the face's") {
  const Body support = table();
  const BodyMotion on(support, 0, still);
  CHECK(face_normal(on, Vec3(1e-7, 0, 1).normalized()) == up);
  const Vec3 off = Vec3(1e-3, 0, 1).normalized();
  CHECK(face_normal(on, off) == off);
}

}  // namespace
}  // namespace touchstone::fast::simulation
