// Which scenes depend on how a declared engine differs from the laws.
#include "oracle/dynamics.h"

#include "oracle/subject.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

/// Two balls of 1 m and 1 kg m⁻³; A approaches at 2 m/s.
Scene balls(const Material& a, const Material& b) {
  Scene scene;
  scene.bodies.resize(2);
  for (Body& body : scene.bodies) body.shape = Sphere{1};
  scene.bodies[1].X_WB.p_WB.x() = 2;
  scene.bodies[0].velocity.v_WBcm.x() = 2;
  scene.bodies[0].material = a;
  scene.bodies[1].material = b;
  return scene;
}

Scene moving(const Material& a, const Material& b) {
  Scene scene = balls(a, b);
  scene.motion.emplace();
  scene.motion->sample_times = {3};
  return scene;
}

Scene impact_of(double restitution, double friction) {
  Scene scene = balls({}, {});
  scene.contact.emplace();
  scene.contact->p_WC.x() = 1;
  scene.contact->nhat_BA_W = {-1, 0, 0};
  scene.contact->restitution = restitution;
  scene.contact->friction = friction;
  return scene;
}

template <class Member, class Value>
Dynamics with(Member member, Value value) {
  Dynamics dynamics;
  dynamics.*member = value;
  return dynamics;
}

bool depends(const Dynamics& dynamics, const Scene& scene) {
  return (scene.contact ? beyond_impact(dynamics, scene) : beyond_motion(dynamics, scene)).has_value();
}

TEST_CASE("dynamics: without a difference no scene is outside") {
  CHECK_FALSE(depends({}, moving({0.5, 0.5}, {1, 1})));
  CHECK_FALSE(depends({}, impact_of(1, 1)));
}

TEST_CASE("dynamics: an impact slower than the threshold does not bounce, and friction may be a pyramid") {
  CHECK(depends(with(&Dynamics::restitution_threshold, 2.001), impact_of(1, 0)));
  CHECK_FALSE(depends(with(&Dynamics::restitution_threshold, 1.999), impact_of(1, 0)));
  CHECK_FALSE(depends(with(&Dynamics::restitution_threshold, 2.001), impact_of(0, 0)));
  CHECK(depends(with(&Dynamics::friction_pyramid, true), impact_of(0, 0.5)));
  CHECK_FALSE(depends(with(&Dynamics::friction_pyramid, true), impact_of(1, 0)));
}

TEST_CASE("dynamics: rules that combine coefficients matter where they make another one than the least") {
  const auto outside = [](Combine rule, double a, double b) {
    const bool restitution = depends(with(&Dynamics::restitution, rule), moving({a, 0}, {b, 0}));
    CHECK(depends(with(&Dynamics::friction, rule), moving({0, a}, {0, b})) == restitution);
    return restitution;
  };
  for (const Combine rule : {Combine::max, Combine::mean, Combine::geometric_mean}) {
    CHECK(outside(rule, 0.25, 0.5));
    CHECK_FALSE(outside(rule, 0.3, 0.3));
  }
  CHECK(outside(Combine::product, 0.5, 0.5));
  CHECK_FALSE(outside(Combine::product, 0.5, 1));
  CHECK_FALSE(outside(Combine::min, 0.25, 0.5));
  Scene fixed = moving({0.25, 0}, {0.5, 0});
  for (Body& body : fixed.bodies) body.mass = Fixed{};
  CHECK_FALSE(depends(with(&Dynamics::restitution, Combine::max), fixed));
}

TEST_CASE("dynamics: thresholds, damping, limits and sleep count by the speeds that a motion may have") {
  const Scene bouncing = moving({1, 0}, {1, 0});
  CHECK(depends(with(&Dynamics::restitution_threshold, 4.001), bouncing));  // two bodies of 2 m/s each
  CHECK_FALSE(depends(with(&Dynamics::restitution_threshold, 3.999), bouncing));
  CHECK(depends(with(&Dynamics::linear_damping, 0.1), bouncing));
  CHECK_FALSE(depends(with(&Dynamics::angular_damping, 0.1), bouncing));
  CHECK(depends(with(&Dynamics::speed_limit, 1.999), bouncing));
  CHECK_FALSE(depends(with(&Dynamics::speed_limit, 2.001), bouncing));
  Scene falling = bouncing;
  falling.gravity.z() = -10;  // 30 m/s more after 3 s
  CHECK(depends(with(&Dynamics::speed_limit, 31.999), falling));
  CHECK_FALSE(depends(with(&Dynamics::speed_limit, 32.001), falling));
  Scene turning = bouncing;
  turning.bodies[1].velocity.w_WB.y() = 4;
  CHECK(depends(with(&Dynamics::angular_damping, 0.1), turning));
  CHECK(depends(with(&Dynamics::angular_speed_limit, 3.999), turning));
  CHECK_FALSE(depends(with(&Dynamics::angular_speed_limit, 4.001), turning));
  CHECK(depends(with(&Dynamics::sleep, Sleep{2.001, 1, 2.999}), bouncing));
  CHECK_FALSE(depends(with(&Dynamics::sleep, Sleep{2.001, 1, 3.001}), bouncing));
  CHECK_FALSE(depends(with(&Dynamics::sleep, Sleep{1.999, 1, 2.999}), bouncing));
}

TEST_CASE("card: the coarsest precision counts of the query's and of the scene's shapes") {
  Card card;
  card.precision = Precision::binary64;
  card.precision_of = {{"mass", Precision::binary32}, {"box", Precision::binary32}, {"sphere", Precision::exact}};
  Scene scene = balls({}, {});
  CHECK(precision_for(card, "distance", scene) == Precision::binary64);
  CHECK(precision_for(card, "mass", scene) == Precision::binary32);
  scene.bodies[1].shape = Compound{{{Pose{}, Box{{1, 1, 1}}}}};
  CHECK(precision_for(card, "distance", scene) == Precision::binary32);
}

TEST_CASE("card: a pair is granted the slop, and the margins of both") {
  CHECK(DistanceTolerance{1, 0.5, 0.25, 0.125}.of(2) == 2.5);
}

}  // namespace
}  // namespace touchstone::oracle
