// What the cards of built engines declare about their dynamics is what these engines do.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/process/pipe.h"
#include "oracle/rotation.h"
#include "tests/catch.h"
#include "tests/oracle/built_subjects.h"

namespace touchstone::oracle {
namespace {

/// The built subjects that answer a query and declare something.
template <class Declares>
std::vector<std::unique_ptr<Subject>> declaring(const std::string& query, const Declares& declares) {
  std::vector<std::unique_ptr<Subject>> subjects = answering(query);
  std::erase_if(subjects, [&](const auto& subject) { return !declares(subject->card().dynamics); });
  return subjects;
}

Scene moving(Body ball, double seconds) {
  Scene scene;
  Body table;
  table.shape = Box{{20, 20, 1}};
  table.X_WB.p_WB = {0, 0, -1};
  table.mass = Fixed{};
  table.material = {1, 0};
  scene.bodies = {std::move(ball), std::move(table)};
  scene.motion.emplace();
  scene.motion->sample_times = {seconds};
  return scene;
}

/// An elastic ball of 1 m above a table.
Body ball(const Vec3& p_WB, const Velocity& velocity) {
  Body made;
  made.shape = Sphere{0.5};
  made.X_WB.p_WB = p_WB;
  made.velocity = velocity;
  made.material = {1, 0};
  return made;
}

State last_state(Subject& subject, const Scene& scene) {
  const Answer<Trajectory> answer = subject.simulation(scene);
  REQUIRE(std::holds_alternative<Trajectory>(answer));
  return std::get<Trajectory>(answer).states.back()[0];
}

TEST_CASE("declared dynamics: an approach that is slower than the restitution threshold does not bounce") {
  const auto subjects = declaring("simulation", [](const Dynamics& it) { return it.restitution_threshold > 0; });
  REQUIRE(subjects.size() >= 2);
  int bounce = 0;  // Bullet loses the restitution of faster approaches too, since its contacts begin before they touch
  for (const auto& subject : subjects) {
    CAPTURE(subject->card().name);
    const Dynamics& dynamics = subject->card().dynamics;
    const auto dropped = [&](double times) {
      const double speed = times * dynamics.restitution_threshold;
      return moving(ball({0, 0, 0.5 + speed / 8}, {{0, 0, -speed}, Vec3::Zero()}), 0.5);
    };
    const Scene slow = dropped(0.45), fast = dropped(20);
    CHECK(beyond_motion(dynamics, slow));
    CHECK(last_state(*subject, slow).velocity.v_WBcm.z() < 0.1 * dynamics.restitution_threshold);
    CHECK_FALSE(beyond_motion(dynamics, fast));
    bounce += last_state(*subject, fast).velocity.v_WBcm.z() > dynamics.restitution_threshold;
  }
  CHECK(bounce >= 1);
}

TEST_CASE("declared dynamics: a body that spins faster than the limit turns less than it should") {
  const auto subjects = declaring("simulation", [](const Dynamics& it) { return it.angular_speed_limit.has_value(); });
  REQUIRE(subjects.size() >= 2);
  for (const auto& subject : subjects) {
    CAPTURE(subject->card().name);
    const Dynamics& dynamics = subject->card().dynamics;
    const double limit = *dynamics.angular_speed_limit, step = subject->card().stepping->step;
    const auto turned = [&](double times) {
      const Scene scene = moving(ball({0, 0, 9}, {Vec3::Zero(), {0, 0, times * limit}}), step);
      CHECK(beyond_motion(dynamics, scene).has_value() == (times > 1));
      return 2 * std::acos(std::abs(rotation(last_state(*subject, scene).X_WB.q_WB).w()));
    };
    CHECK(turned(0.9) == Approx(0.9 * limit * step).epsilon(1e-4));
    CHECK(turned(1.5) < 0.97 * 1.5 * limit * step);
  }
}

// A cone leaves mu P_n of friction in each direction of slip.
TEST_CASE("declared dynamics: friction by a pyramid is greater in some directions") {
  const auto subjects = declaring("impulse", [](const Dynamics& it) { return it.friction_pyramid; });
  REQUIRE(!subjects.empty());
  Scene scene = moving(ball({0, 0, 0.5}, {}), 1);
  scene.motion.reset();
  scene.contact.emplace();
  scene.contact->law = Law::newton;
  scene.contact->nhat_BA_W = {0, 0, 1};
  scene.contact->friction = 0.01;
  CHECK(beyond_impact(subjects[0]->card().dynamics, scene));
  for (const auto& subject : subjects) {
    CAPTURE(subject->card().name);
    double most = 0;
    for (int eighth = 0; eighth < 8; ++eighth) {
      const double angle = eighth * std::numbers::pi / 8;
      const Vec3 v(std::cos(angle), std::sin(angle), -1);
      scene.bodies[0].velocity.v_WBcm = v;
      const Answer<Impulse> answer = subject->impulse(scene);
      REQUIRE(std::holds_alternative<Impulse>(answer));
      const Vec3 change = std::get<Impulse>(answer).after[0].v_WBcm - v;
      most = std::max(most, change.head<2>().norm() / (0.01 * change.z()));
    }
    CHECK(most > 1.3);
  }
}

}  // namespace
}  // namespace touchstone::oracle
