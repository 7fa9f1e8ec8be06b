#include "oracle/judge/grade.h"

#include "model/infinity.h"
#include "oracle/judge/judge.h"
#include "oracle/tolerance/tolerance.h"
#include "tests/catch.h"

using namespace touchstone;
using namespace touchstone::oracle;

namespace {

Finding failing(double error, double allowed, Defect defect = Defect::too_far) {
  Finding finding;
  finding.outcome = Outcome::fails;
  finding.defect = defect;
  finding.error = error;
  finding.allowed = allowed;
  finding.unit = "ulps of the scene's scale";
  return finding;
}

}  // namespace

TEST_CASE("grades: by how many times the allowance, F for no answer and for wrong verdicts in plain sight") {
  CHECK(grade(Finding{}) == Grade::A);
  CHECK(grade(failing(251, 250)) == Grade::B);
  CHECK(grade(failing(250 * 0x1p10, 250)) == Grade::B);
  CHECK(grade(failing(250 * 0x1p11, 250)) == Grade::C);
  CHECK(grade(failing(250 * 0x1p21, 250)) == Grade::D);
  CHECK(grade(failing(1, 0, Defect::broken_enclosure)) == Grade::B);
  CHECK(grade(failing(0x1p11, 0)) == Grade::C);
  CHECK(grade(failing(251, 250, Defect::missed)) == Grade::B);
  CHECK(grade(failing(250 * 0x1p21, 250, Defect::missed)) == Grade::F);
  CHECK(grade(failing(250 * 0x1p21, 250, Defect::phantom)) == Grade::F);
  CHECK(grade(failing(0, 0, Defect::not_finite)) == Grade::F);
  Finding unsized = failing(1, 0, Defect::nondeterministic);
  unsized.unit = without_size;
  CHECK(grade(unsized) == Grade::D);
  Finding cuts = failing(3, 0, Defect::wrong_box);
  cuts.rounding = 208;
  CHECK(grade(cuts) == Grade::A_minus);
  cuts.error = 209;
  CHECK(grade(cuts) == Grade::B);
  Finding broken;
  broken.outcome = Outcome::breaks;
  CHECK(grade(broken) == Grade::F);
  broken.defect = Defect::refused;  // an engine that says so is no worse than one that breaks a law
  CHECK(grade(broken) == Grade::D);
  CHECK(name_of(Grade::A) + name_of(Grade::A_minus) + name_of(Grade::B) + name_of(Grade::F) == "AA-BF");
}

TEST_CASE("grades: F for an answer without a right digit, if the error shows on the body") {
  // A binary32 engine says 0 for 0.83 m between balls of 1 m at a scale of 3 m: 250 ulps are allowed, 4.6e6 are
  // missing.
  Finding zero = failing(0.83 / 3 * 0x1p24, 250, Defect::too_near);
  CHECK(grade(zero) == Grade::C);
  zero.relative = 1;
  zero.of_body = 0.83;
  CHECK(grade(zero) == Grade::F);
  zero.of_body = 0.9 * 0x1p-10;  // less than a thousandth of the body
  CHECK(grade(zero) == Grade::C);
  Finding no_mass = failing(0x1p24, 300, Defect::wrong_mass);
  no_mass.relative = 1;  // not a length
  CHECK(grade(no_mass) == Grade::F);
  Finding verdict = failing(250 * 0x1p11, 250, Defect::phantom);
  verdict.of_body = 0.1;
  CHECK(grade(verdict) == Grade::F);
  verdict.of_body = 1e-4;
  CHECK(grade(verdict) == Grade::C);
}

TEST_CASE("grades: by the share of the exact value that an error is, where the clause promises those digits") {
  const auto of = [](double relative, double allowed_share) {
    Finding finding = failing(0x1p53 * relative, 0x1p53 * allowed_share, Defect::wrong_mass);
    finding.relative = relative;
    return grade(finding);
  };
  // An inertia off by 37 %, of a hull of 12 triangles in single precision: 146 u · 11.4 · 18 = 0.0018 are allowed.
  CHECK(of(0.37, 0.0018) == Grade::D);
  CHECK(of(0.37, 0.1) == Grade::D);
  CHECK(of(0.37, 0.11) == Grade::B);  // no digit is promised
  CHECK(of(0.19, 0.1) == Grade::B);   // more than half of the error may be rounding
  CHECK(of(0.5, 0.06) == Grade::D);
  CHECK(of(0.51, 0.06) == Grade::F);  // not the first bit
  CHECK(of(1, 0.1) == Grade::F);
  CHECK(of(1, 0.2) == Grade::B);
  CHECK(of(0.1, 0.0009) == Grade::C);
  CHECK(of(0.1, 0.001) == Grade::B);  // three digits are not promised
  CHECK(of(0x1p-10, 0x1p-15) == Grade::B);
  CHECK(of(0.001, 0x1p-11) == Grade::C);
  CHECK(of(1e-5, 1e-14) == Grade::D);  // binary64 promises more digits, so e is the stricter
}

TEST_CASE("grades: an error in metres is compared with the metres that are allowed, not with one metre") {
  Finding far = failing(0.3, 0.001, Defect::wrong_motion);
  far.unit = "m";
  CHECK(grade(far) == Grade::B);
  far.error = 1.5;
  CHECK(grade(far) == Grade::C);
  far.allowed = 0;
  CHECK(grade(far) == Grade::D);
}

TEST_CASE("grades: the excess is the error over what is allowed, of ulps, over one ulp at least") {
  Finding finding = failing(6, 2, Defect::too_much_work);
  finding.unit = "times the promised work";
  CHECK(excess(finding) == 3);
  finding.allowed = 0.25;
  CHECK(excess(finding) == 24);
  finding.allowed = 0;
  CHECK(excess(finding) == infinity);
  finding.unit = "ulps of the scene's scale";
  CHECK(excess(finding) == 6);
  finding.error = 0;
  CHECK(excess(finding) == 0);
}

TEST_CASE("grades: a length counts by its share of the exact value or of the smaller body, whichever is less") {
  Finding length = failing(500, 1, Defect::too_near);  // no more is promised than B forgives
  length.relative = 1;
  length.of_body = 0.83;
  CHECK(grade(length) == Grade::F);
  length.of_body = 0.2;
  CHECK(grade(length) == Grade::D);
  length.of_body = 0.05;
  CHECK(grade(length) == Grade::C);
  length.of_body = 0.0005;
  CHECK(grade(length) == Grade::B);
  length.of_body = 0.2;
  length.relative = 1e-4;  // 20 cm of 2 km
  CHECK(grade(length) == Grade::B);
  length.relative.reset();
  CHECK(grade(length) == Grade::D);
  length.defect = Defect::phantom;  // a wrong verdict has no right digit; what shows is the body's share
  CHECK(grade(length) == Grade::D);
  length.of_body = 0.6;
  CHECK(grade(length) == Grade::F);
}

TEST_CASE("grades: a failure says how large its error is beside the exact value and beside the smaller body") {
  Scene scene;
  scene.bodies.assign(2, Body{"", Sphere{1}, {}, {}, {}, {}});
  scene.bodies[0].shape = Sphere{2};
  scene.bodies[1].X_WB.p_WB.x() = 3.75;
  Card card;
  card.precision = Precision::binary32;
  const auto said = [&](double distance, const Interval& truth) {
    const double allowed = tolerance::distance(scene, card.precision);
    return judge::near(distance, truth, judge::in_ulps(scene, card, allowed), Defect::too_near, Defect::too_far);
  };
  const Finding zero = said(0, {0.75, 0.75});
  CHECK(zero.relative == 1.0);
  CHECK(zero.of_body == 0.75);
  CHECK(grade(zero) == Grade::F);
  const Finding half = said(0.375, {0.75, 0.75});
  CHECK(half.relative == 0.5);
  CHECK(grade(half) == Grade::D);
  CHECK(grade(said(0.75, {0, 0})) == Grade::F);  // for bodies that overlap
  const Finding right = said(0.75, {0.75, 0.75});
  CHECK_FALSE(right.relative);
  CHECK_FALSE(right.of_body);
}

TEST_CASE("grades: the exact value of an entry is that of its vector or matrix") {
  const judge::Allowance allowed{0x1p-20, 0x1p-24, "ulps", 0, 2.0};
  const Finding product = judge::near(0.5, {0, 0}, allowed, Defect::wrong_mass, Defect::wrong_mass);
  CHECK(product.relative == 0.25);
  CHECK_FALSE(product.of_body);
}
