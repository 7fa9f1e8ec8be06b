// The outcomes of properties of constrained motion, for trajectories on paper.
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"

namespace touchstone::properties {
namespace {

/// What is said about a ball of 2 kg that moves by itself, if its speed becomes 1 + `more` m/s.
oracle::Finding judged(const std::string& property, double more) {
  Scene scene;
  Body& ball = scene.bodies.emplace_back();
  ball.shape = Sphere{1};
  ball.mass = MassProperties{2, Vec3::Zero(), Mat3::Identity()};
  ball.velocity.v_WBcm = {1, 0, 0};
  scene.motion.emplace();
  scene.motion->sample_times = {1, 2};
  Trajectory said;
  for (const double t : scene.motion->sample_times) {
    State state{ball.X_WB, ball.velocity};
    state.X_WB.p_WB.x() = t;
    state.velocity.v_WBcm.x() += more;
    said.states.push_back({state});
  }
  said.events.emplace();
  said.complete_until = 2;
  tests::FixedSubject subject;
  subject.said_constraint = said;
  return find(property).check(scene, subject);
}

// Without gravity no step and no overlap changes the energy of 1 J: 2^-40 J are left for rounding.
TEST_CASE("constraint.energy: without gravity it rises by no more than rounding") {
  CHECK(judged("constraint.energy", 0).outcome == oracle::Outcome::holds);
  CHECK(judged("constraint.energy", -0.5).outcome == oracle::Outcome::holds);
  CHECK(judged("constraint.energy", 0x1p-42).outcome == oracle::Outcome::holds);
  CHECK(judged("constraint.energy", 0x1p-40).defect == oracle::Defect::wrong_energy);
  CHECK(judged("constraint.energy", 0x1p-36).defect == oracle::Defect::wrong_energy);
}

}  // namespace
}  // namespace touchstone::properties
