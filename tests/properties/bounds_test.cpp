// The outcomes of the bounds properties, for answers computed by hand.
#include <cmath>
#include <limits>

#include "oracle/judge/grade.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;

namespace {

oracle::Finding judged(const std::string& property, Answer<Bounds> said, double margin = 0,
                       const Scene& scene = tests::scene("cubes that share a face")) {  // B at (0, 2, 0.5)
  tests::FixedSubject subject;
  subject.introduced.broad_phase_margin = margin;
  subject.said_bounds = std::move(said);
  return properties::find(property).check(scene, subject);
}

Bounds grown(double by) {
  const Vec3 b(by, by, by);
  return {{Vec3(-1, -1, -1) - b, Vec3(1, 1, 1) + b}, {Vec3(-1, 1, -0.5) - b, Vec3(1, 3, 1.5) + b}};
}

}  // namespace

TEST_CASE("bounds.holds_body: not one bit inside") {
  CHECK(judged("bounds.holds_body", grown(0)).outcome == Outcome::holds);
  CHECK(judged("bounds.holds_body", grown(1)).outcome == Outcome::holds);
  Bounds cut = grown(0);
  cut[1].hi.y() = std::nextafter(3.0, 0.0);
  const auto finding = judged("bounds.holds_body", cut);
  CHECK(finding.outcome == Outcome::fails);
  CHECK(finding.defect == Defect::wrong_box);
  CHECK(finding.error > 0);
  CHECK(finding.observed.starts_with("bodies[1]"));
  CHECK(oracle::grade(finding) == oracle::Grade::A_minus);  // not rounded outward
  cut[1].hi.y() = 2.99;
  CHECK(oracle::grade(judged("bounds.holds_body", cut)) > oracle::Grade::A_minus);
}

TEST_CASE("bounds.tight: rounding and the declared margin, no more") {
  CHECK(judged("bounds.tight", grown(1e-14)).outcome == Outcome::holds);
  CHECK(judged("bounds.tight", grown(1e-9)).defect == Defect::loose_box);
  CHECK(judged("bounds.tight", grown(0.04), 0.04).outcome == Outcome::holds);
  CHECK(judged("bounds.tight", grown(0.05), 0.04).outcome == Outcome::fails);
}

// An octahedron turned by 45° about z reaches to 1/√2 in x and y. The box about it in its own axes, so turned, to √2.
TEST_CASE("bounds.tight: an answer is compared with the kind of box that the card declares") {
  Scene scene;
  Body& body = scene.bodies.emplace_back();
  body.shape = Polytope{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  body.X_WB.q_WB = {std::cos(std::atan(1.0) / 2), 0, 0, std::sin(std::atan(1.0) / 2)};
  tests::FixedSubject subject;
  const auto outcome = [&](double side, oracle::BoxKind kind) {
    subject.introduced.boxes = kind;
    subject.said_bounds = Bounds{{Vec3(-side, -side, -1), Vec3(side, side, 1)}};
    return properties::find("bounds.tight").check(scene, subject).outcome;
  };
  const double tight = std::sqrt(0.5) * (1 + 1e-15), loose = std::sqrt(2.0);
  CHECK(outcome(tight, oracle::BoxKind::tight) == Outcome::holds);
  CHECK(outcome(loose, oracle::BoxKind::tight) == Outcome::fails);
  CHECK(outcome(loose, oracle::BoxKind::of_turned_box) == Outcome::holds);
  CHECK(outcome(tight, oracle::BoxKind::of_turned_box) == Outcome::holds);
  CHECK(outcome(1.01 * loose, oracle::BoxKind::of_turned_box) == Outcome::fails);
  const Polytope octahedron = std::get<Polytope>(body.shape);
  for (const Shape& shape : {Shape(octahedron), Shape(Sphere{1}), Shape(Box{{1, 1, 1}})}) {  // all have the same ball
    body.shape = shape;
    CHECK(outcome(std::sqrt(3.0), oracle::BoxKind::of_ball) == Outcome::holds);
    CHECK(outcome(1.01 * std::sqrt(3.0), oracle::BoxKind::of_ball) == Outcome::fails);
  }
  for (const Part& part : {Part{Pose{}, octahedron}, Part{Pose{}, Sphere{1}}}) {  // also about a ball, if it is a part
    body.shape = Compound{{part}};
    CHECK(outcome(1.001, oracle::BoxKind::tight) == Outcome::fails);
    CHECK(outcome(loose, oracle::BoxKind::of_turned_box) == Outcome::holds);
    CHECK(outcome(1.01 * loose, oracle::BoxKind::of_turned_box) == Outcome::fails);
  }
  body.shape = Compound{{{Pose{}, octahedron}}};
  CHECK(outcome(loose, oracle::BoxKind::of_turned_box) == Outcome::holds);
}

TEST_CASE("bounds.tight: judged in the precision that the card declares for a shape") {
  tests::FixedSubject subject;
  subject.said_bounds = grown(1e-6);
  const auto outcome = [&](const std::string& shape) {
    subject.introduced.precision_of = {{shape, oracle::Precision::binary32}};
    return properties::find("bounds.tight").check(tests::scene("cubes that share a face"), subject).outcome;
  };
  CHECK(outcome("sphere") == Outcome::fails);
  CHECK(outcome("bounds") == Outcome::holds);
  CHECK((outcome("polytope") == Outcome::holds) != (outcome("box") == Outcome::holds));
}

TEST_CASE("bounds: one box a body") {
  CHECK(judged("bounds.tight", Bounds{grown(0)[0]}).defect == Defect::wrong_box);
  CHECK(judged("bounds.survives", Bounds{grown(-5)}).outcome == Outcome::fails);
  CHECK(judged("bounds.alone", grown(0)).defect == Defect::relabelled);  // a constant cannot follow a change of order
}

TEST_CASE("bounds.survives: infinity is no fault where the exact box ends beyond the subject's numbers") {
  const double far = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const Bounds everything = {{Vec3::Constant(-infinity), Vec3::Constant(infinity)}};
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].shape = Sphere{far};
  CHECK(judged("bounds.survives", everything, 0, scene).outcome == Outcome::fails);
  scene.bodies[0].X_WB.p_WB = Vec3(far, 0, 0);
  CHECK(judged("bounds.survives", everything, 0, scene).outcome == Outcome::outside);
}
