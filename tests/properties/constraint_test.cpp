// The outcomes of properties of constrained motion, for trajectories on paper.
#include <Eigen/Geometry>

#include "oracle/rotation.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/reference.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

namespace touchstone::properties {
namespace {

/// What is said about a ball of 2 kg that moves by itself at 1 m/s, if it has these speeds (m/s) after 1 s, 2 s, ...
oracle::Finding judged(const std::string& property, const std::vector<double>& speeds) {
  Scene scene;
  Body& ball = scene.bodies.emplace_back();
  ball.shape = Sphere{1};
  ball.mass = MassProperties{2, Vec3::Zero(), Mat3::Identity()};
  ball.velocity.v_WBcm = {1, 0, 0};
  scene.motion.emplace();
  Trajectory said;
  for (const double speed : speeds) {
    scene.motion->sample_times.push_back(static_cast<double>(said.states.size()) + 1);
    State state{ball.X_WB, ball.velocity};
    state.X_WB.p_WB.x() = scene.motion->sample_times.back();
    state.velocity.v_WBcm.x() = speed;
    said.states.push_back({state});
  }
  said.events.emplace();
  said.complete_until = scene.motion->sample_times.back();
  tests::FixedSubject subject;
  subject.said_constraint = said;
  return find(property).check(scene, subject);
}

oracle::Finding judged(const std::string& property, double more) {
  return judged(property, std::vector<double>{1 + more, 1 + more});
}

// Without gravity no step and no overlap changes the energy of 1 J: 2^-40 J are left for rounding.
TEST_CASE("constraint.energy: without gravity it rises by no more than rounding") {
  CHECK(judged("constraint.energy", 0).outcome == oracle::Outcome::holds);
  CHECK(judged("constraint.energy", -0.5).outcome == oracle::Outcome::holds);
  CHECK(judged("constraint.energy", 0x1p-42).outcome == oracle::Outcome::holds);
  CHECK(judged("constraint.energy", 0x1p-40).defect == oracle::Defect::wrong_energy);
  CHECK(judged("constraint.energy", 0x1p-36).defect == oracle::Defect::wrong_energy);
}

TEST_CASE("constraint.energy: what was lost does not come back") {
  CHECK(judged("constraint.energy", {1, 0.75, 0.5}).outcome == oracle::Outcome::holds);
  CHECK(judged("constraint.energy", {1, 0.5, 0.75}).defect == oracle::Defect::wrong_energy);
}

/// A block or a ball that is thrown onto a table.
Scene thrown(Shape shape, const Material& material) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0] = {"thrown", std::move(shape), {{0, 0, 4}, {}},
                     {},       material,         MassProperties{1, Vec3::Zero(), Mat3::Identity()}};
  scene.bodies[1] = {"table", Box{{8, 8, 1}}, {{0, 0, -1}, {}}, {}, material, Fixed{}};
  scene.gravity = {0, 0, -8};
  scene.motion = Motion{.sample_times = {1}};
  return scene;
}

/// Two balls in one body.
Compound dumbbell() { return {{{{{-1, 0, 0}, {}}, Sphere{1}}, {{{1, 0, 0}, {}}, Sphere{1}}}}; }

TEST_CASE("constraint.apart: a compound that sinks into a table is judged too") {
  const Scene scene = thrown(dumbbell(), {0, 0});
  for (const double z : {1.0, 0.5}) {
    tests::FixedSubject subject;
    Trajectory said;
    said.states = {{{{{0, 0, z}, {}}, {}}, {scene.bodies[1].X_WB, {}}}};
    subject.said_constraint = said;
    const oracle::Finding finding = find("constraint.apart").check(scene, subject);
    CHECK((z < 1 ? finding.defect == oracle::Defect::overdeep : finding.outcome == oracle::Outcome::holds));
  }
}

TEST_CASE("constraint.cone: a normal longer than 1 gives no more friction, and is none") {
  const Scene scene = thrown(Sphere{1}, {0, 1});
  const auto outcome = [&](double length, double P_t) {
    Event event;
    event.kind = Event::Kind::impact;
    event.time = 0.5;
    event.a = 0, event.b = 1;
    event.nhat_BA_W = {0, 0, length};
    event.P_A_W = {P_t, 0, 1};
    tests::FixedSubject subject;
    Trajectory said;
    said.states = {{{scene.bodies[0].X_WB, {}}, {scene.bodies[1].X_WB, {}}}};
    said.events.emplace(1, event);
    subject.said_constraint = said;
    return find("constraint.cone").check(scene, subject).outcome;
  };
  CHECK(outcome(1, 1) == oracle::Outcome::holds);
  CHECK(outcome(1, 1.1) == oracle::Outcome::fails);
  CHECK(outcome(1.2, 1.1) == oracle::Outcome::fails);
  CHECK(outcome(1.2, 0) == oracle::Outcome::fails);
}

TEST_CASE("constraint: a run that ends before the first sample holds nothing, and has no event after its end") {
  const Scene scene = thrown(Sphere{1}, {0, 1});
  const auto outcome = [&](const char* property, double event_at, double complete_until = 0.5) {
    Event event;
    event.kind = Event::Kind::impact;
    event.time = event_at;
    event.a = 0, event.b = 1;
    event.nhat_BA_W = event.P_A_W = {0, 0, 1};
    tests::FixedSubject subject;
    Trajectory said;
    said.complete_until = complete_until;
    if (complete_until >= 1) said.states = {{{scene.bodies[0].X_WB, {}}, {scene.bodies[1].X_WB, {}}}};
    said.events.emplace(1, event);
    subject.said_constraint = said;
    return find(property).check(scene, subject).outcome;
  };
  CHECK(outcome("constraint.energy", 0.5) == oracle::Outcome::abstains);
  CHECK(outcome("constraint.fixed", 0.5) == oracle::Outcome::abstains);
  CHECK(outcome("constraint.survives", 0.5) == oracle::Outcome::holds);
  CHECK(outcome("constraint.survives", 0.625) == oracle::Outcome::fails);
  CHECK(outcome("constraint.survives", 1, 2) == oracle::Outcome::holds);
  CHECK(outcome("constraint.survives", 1.5, 2) == oracle::Outcome::fails);  // after the last sample
}

// By Newton's rule a tetrahedron gained 1 % of its energy.
TEST_CASE("constraint.energy: rebounds with friction are judged of balls alone") {
  const auto judges = [](const Scene& scene) {
    const auto fast = oracle::subjects::make_fast();
    return find("constraint.energy").check(scene, *fast).outcome == oracle::Outcome::holds;
  };
  CHECK(judges(thrown(Sphere{1}, {0.5, 0.5})));
  CHECK_FALSE(judges(thrown(Box{{1, 1, 1}}, {0.5, 0.5})));
  CHECK(judges(thrown(Box{{1, 1, 1}}, {0, 0.5})));
  CHECK(judges(thrown(Box{{1, 1, 1}}, {0.5, 0})));
}

std::vector<Eigen::Quaterniond> orientations(const Answer<Trajectory>& said) {
  std::vector<Eigen::Quaterniond> all;
  for (const std::vector<State>& states : std::get<Trajectory>(said).states) {
    all.push_back(oracle::rotation(states.front().X_WB.q_WB));
  }
  return all;
}

// It rolls at 1 m/s with 4 rad/s about y until it meets the obstacle after 1/2 s.
TEST_CASE("the reference's ball turns by its angular velocity") {
  const auto reference = oracle::subjects::make_reference();
  const auto turned = orientations(reference->constraint(tests::scene("a ball that an obstacle sends back")));
  CHECK(turned[0].angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(1, Vec3::UnitY()))) < 1e-12);
}

TEST_CASE("the reference's ball and that of fast turn alike, through slip and impacts") {
  const auto reference = oracle::subjects::make_reference(), fast = oracle::subjects::make_fast();
  int compared = 0;
  for (const Scene& scene : tests::scenes_of("constraint")) {
    const Answer<Trajectory> exact = reference->constraint(scene);
    if (!std::holds_alternative<Trajectory>(exact)) continue;
    INFO(scene.name);
    const auto expected = orientations(exact), said = orientations(fast->constraint(scene));
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(said.at(i).angularDistance(expected[i]) < 0.02);
    ++compared;
  }
  CHECK(compared >= 9);
}

}  // namespace
}  // namespace touchstone::properties
