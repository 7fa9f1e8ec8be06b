// The outcomes of the impulse properties, for answers computed by hand.
#include <Eigen/Geometry>
#include <cmath>

#include "oracle/truth/impact.h"
#include "oracle/truth/truth.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;

namespace {

const Scene& skid() { return tests::scene("a ball that skids"); }

// m = 1, I = 1/2, radius 1, e = 1/2, mu = 1/8, u = (3, 1, -1): P_n = 3/2, P_t = 3/16 against (3, 1)/√10, far from zero
// slip.
Impulse skidding() {
  const Vec3 t = Vec3(3, 1, 0) / std::sqrt(10.0);
  Impulse said;
  said.P_A_W = Vec3(0, 0, 1.5) - 0.1875 * t;
  said.after[0] = {Vec3(3, 1, -1) + *said.P_A_W, 2 * Vec3(0, 0, -1).cross(*said.P_A_W)};
  said.after[1] = {};
  return said;
}

oracle::Finding judged(const std::string& property, const Scene& scene, const Impulse& said) {
  tests::FixedSubject subject;
  subject.said_impulse = said;
  return properties::find(property).check(scene, subject);
}

oracle::Finding judged(const std::string& property, const Impulse& said) { return judged(property, skid(), said); }

}  // namespace

TEST_CASE("impulse: the answer on paper holds") {
  for (const char* property : {"impulse.agrees", "impulse.angular_momentum", "impulse.fixed", "impulse.stated",
                               "impulse.push", "impulse.cone", "impulse.energy", "impulse.energy_floor",
                               "impulse.straight", "impulse.no_approach", "impulse.decided", "impulse.survives"}) {
    INFO(property);
    CHECK(judged(property, skidding()).outcome == Outcome::holds);
  }
  for (const char* property : {"impulse.momentum", "impulse.frictionless", "impulse.stuck", "impulse.newton",
                               "impulse.plastic", "impulse.separating"}) {
    INFO(property);
    CHECK(judged(property, skidding()).outcome == Outcome::outside);
  }
}

TEST_CASE("impulse: each wrong part is found by its own property") {
  Impulse spun = skidding();
  spun.after[0].w_WB.x() += 1e-12;
  CHECK(judged("impulse.angular_momentum", spun).defect == Defect::wrong_momentum);
  CHECK(judged("impulse.agrees", spun).defect == Defect::wrong_velocity);
  CHECK(judged("impulse.stated", spun).defect == Defect::inconsistent);
  Impulse kicked = skidding();
  kicked.after[1].v_WBcm.z() = -1e-300;
  CHECK(judged("impulse.fixed", kicked).defect == Defect::wrong_velocity);
  Impulse stated = skidding();
  *stated.P_A_W *= -1;
  CHECK(judged("impulse.push", stated).defect == Defect::pulls);
  stated.P_A_W = Vec3(1.5 * 0.1250001, 0, 1.5);
  CHECK(judged("impulse.cone", stated).defect == Defect::beyond_cone);
  Impulse fast = skidding();
  fast.after[0].v_WBcm.z() = 1.001;
  CHECK(judged("impulse.straight", fast).outcome == Outcome::fails);
  CHECK(judged("impulse.agrees", fast).outcome == Outcome::fails);
  Impulse left = skidding();
  left.after[0].v_WBcm.z() = -1e-9;
  CHECK(judged("impulse.no_approach", left).outcome == Outcome::fails);
  Impulse stopped = skidding();
  stopped.after[0] = {};
  CHECK(judged("impulse.energy_floor", stopped).defect == Defect::wrong_energy);
  Impulse gained = skidding();
  gained.after[0].v_WBcm.x() = 4;
  CHECK(judged("impulse.energy", gained).defect == Defect::wrong_energy);
}

// At e' = 1/4, where e = 0, the ball gains 1/32 J.
TEST_CASE("impulse.energy: a rebound where there is no restitution is a gain, also of less than a third") {
  Scene drop = tests::scene("a ball that skids");
  drop.contact->restitution = drop.contact->friction = 0;
  const auto rebounds = [&](double e) {
    Impulse said;
    said.P_A_W = Vec3(0, 0, 1 + e);
    said.after[0] = {Vec3(3, 1, e), Vec3::Zero()};
    said.after[1] = {};
    return judged("impulse.energy", drop, said).outcome;
  };
  CHECK(rebounds(0) == Outcome::holds);
  CHECK(rebounds(0.25) == Outcome::fails);
}

TEST_CASE("impulse: what is not said is no pass") {
  Impulse silent = skidding();
  CHECK(judged("impulse.error_bound", silent).outcome == Outcome::abstains);
  silent.P_A_W.reset();
  CHECK(judged("impulse.stated", silent).outcome == Outcome::abstains);
  CHECK(judged("impulse.agrees", silent).outcome == Outcome::holds);
}

TEST_CASE("impulse.error_bound: 0 is too little for a rounded impulse, a few ulps are enough") {
  Impulse said = skidding();
  said.error = 0x1p-48;
  CHECK(judged("impulse.error_bound", said).outcome == Outcome::holds);
  said.P_A_W->x() += 0x1p-46;
  CHECK(judged("impulse.error_bound", said).defect == Defect::broken_enclosure);
}

TEST_CASE("impulse.decided: nothing regular is ambiguous, and what may jump is not judged") {
  Impulse shrug = skidding();
  shrug.ambiguous = 1e-12;
  CHECK(judged("impulse.decided", shrug).outcome == Outcome::fails);
  CHECK(judged("impulse.decided", tests::scene("a rod in Painlevé's range"), shrug).outcome == Outcome::outside);
  shrug.ambiguous = -1;
  CHECK(judged("impulse.survives", shrug).outcome == Outcome::fails);
}

// It slips at 100 m/s, and its law jumps at an approach of 0.
TEST_CASE("impulse: where slip jams, an approach is excused only within 1e-9 of the jump") {
  const auto unanswered = [](double approach) {
    Scene rod = tests::scene("a rod in Painlevé's range");
    rod.bodies[0].velocity.v_WBcm.z() = -approach;
    Impulse said;
    said.P_A_W = Vec3::Zero();
    said.after = {rod.bodies[0].velocity, rod.bodies[1].velocity};
    return judged("impulse.agrees", rod, said).outcome;
  };
  CHECK(unanswered(1e-5) == Outcome::fails);
  CHECK(unanswered(1e-9) == Outcome::outside);
}

TEST_CASE("impulse: without a contact, or with squares beyond the subject's range, nothing is asked") {
  CHECK(judged("impulse.agrees", tests::scene("spheres apart"), skidding()).outcome == Outcome::outside);
  Scene hard = skid();
  hard.bodies[0].velocity.v_WBcm *= 0x1p600;
  CHECK(judged("impulse.survives", hard, skidding()).outcome == Outcome::outside);
}

// 8 and 64 ulps are 16 and 128 roundings: 36 are of the body's axes, and 8 · 256 more of two poses 1/256 s apart.
TEST_CASE("impulse: a fixed body's velocity may be kept in its axes, or computed from two poses") {
  Scene scene = skid();
  scene.bodies[1].velocity.w_WB = {0, 0, 1};
  const auto judged_at = [&](double ulps, const std::optional<oracle::Stepping>& stepping) {
    tests::FixedSubject subject;
    subject.introduced.stepping = stepping;
    Impulse said = skidding();
    said.after[1].w_WB = {0, 0, 1 + ulps * 0x1p-52};
    subject.said_impulse = said;
    return properties::find("impulse.fixed").check(scene, subject).outcome;
  };
  CHECK(judged_at(8, std::nullopt) == Outcome::holds);
  CHECK(judged_at(64, std::nullopt) == Outcome::fails);
  CHECK(judged_at(64, oracle::Stepping{1.0 / 256, 1}) == Outcome::holds);
  CHECK(judged_at(1 << 20, oracle::Stepping{1.0 / 256, 1}) == Outcome::fails);
}

TEST_CASE("impulse: the planar rod of literature, by three laws") {
  // K = [[5/2, −3/2], [−3/2, 5/2]] and u = (3, −5), five times the example's: slip stops at p = 3/4, p_c = 2.
  const auto u_n = [](Law law) {
    Scene scene = tests::scene("a rod whose slip stops");
    scene.contact->law = law;
    const oracle::Impact impact = oracle::impact(scene);
    const auto& after = oracle::truth::impulse(scene).after[0];
    const auto v = [](const reference::ExactVec3& x) { return Vec3(x[0].nearest(), x[1].nearest(), x[2].nearest()); };
    return static_cast<double>(impact.u_after({Velocity{v(after.v_WBcm), v(after.w_WB)}, Velocity{}}).z());
  };
  CHECK(u_n(Law::poisson) == Approx(5 * 0.64).epsilon(1e-15));
  CHECK(u_n(Law::newton) == Approx(5).epsilon(1e-15));
  CHECK(u_n(Law::stronge) == Approx(5 * std::sqrt(31 / 62.5)).epsilon(1e-15));
}
