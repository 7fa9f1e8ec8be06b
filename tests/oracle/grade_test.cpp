#include "oracle/judge/grade.h"

#include "tests/catch.h"

using namespace touchstone::oracle;

namespace {

Finding failing(double error, double allowed, Defect defect = Defect::too_far) {
  Finding finding;
  finding.outcome = Outcome::fails;
  finding.defect = defect;
  finding.error = error;
  finding.allowed = allowed;
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
  CHECK(name_of(Grade::A) + name_of(Grade::A_minus) + name_of(Grade::B) + name_of(Grade::F) == "AA-BF");
}
