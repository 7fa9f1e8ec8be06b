// What each outcome of the bounds properties is, on answers by hand.
#include <cmath>

#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;

namespace {

oracle::Finding judged(const std::string& property, Answer<Bounds> said, double margin = 0) {
  tests::FixedSubject subject;
  subject.introduced.broad_phase_margin = margin;
  subject.said_bounds = std::move(said);
  return properties::find(property).check(tests::scene("cubes that share a face"), subject);  // B at (0, 2, 0.5)
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
}

TEST_CASE("bounds.tight: rounding and the declared margin, no more") {
  CHECK(judged("bounds.tight", grown(1e-14)).outcome == Outcome::holds);
  CHECK(judged("bounds.tight", grown(1e-9)).defect == Defect::loose_box);
  CHECK(judged("bounds.tight", grown(0.04), 0.04).outcome == Outcome::holds);
  CHECK(judged("bounds.tight", grown(0.05), 0.04).outcome == Outcome::fails);
}

TEST_CASE("bounds: one box a body") {
  CHECK(judged("bounds.tight", Bounds{grown(0)[0]}).defect == Defect::wrong_box);
  CHECK(judged("bounds.survives", Bounds{grown(-5)}).outcome == Outcome::fails);
  CHECK(judged("bounds.alone", grown(0)).defect == Defect::relabelled);  // a constant cannot follow the bodies' order
}
