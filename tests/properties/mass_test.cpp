// The outcomes of the mass properties, for answers computed by hand.
#include <limits>
#include <utility>

#include "oracle/judge/grade.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;

namespace {

// Two cubes of side 2, density 1: mass 8, inertia 8/12·(4 + 4) = 16/3.
MassProperties cube() {
  MassProperties m;
  m.mass = 8;
  m.I_BBcm_B = Vec3(16.0 / 3, 16.0 / 3, 16.0 / 3).asDiagonal();
  return m;
}

oracle::Finding judged(const std::string& property, const MassProperties& said,
                       oracle::Precision precision = oracle::Precision::binary64) {
  tests::FixedSubject subject;
  subject.introduced.precision = precision;
  subject.said_mass = Masses{cube(), said};
  return properties::find(property).check(tests::scene("cubes that share a face"), subject);
}

}  // namespace

TEST_CASE("mass: right answers hold, and each wrong part is found by its own property") {
  for (const char* property :
       {"mass.mass", "mass.centre", "mass.inertia", "mass.possible", "mass.pose_free", "mass.survives"}) {
    CHECK(judged(property, cube()).outcome == Outcome::holds);
  }
  MassProperties heavy = cube();
  heavy.mass = 8.001;
  CHECK(judged("mass.mass", heavy).defect == Defect::wrong_mass);
  CHECK(judged("mass.centre", heavy).outcome == Outcome::holds);
  MassProperties off = cube();
  off.p_BBcm.z() = 1e-9;
  CHECK(judged("mass.centre", off).outcome == Outcome::fails);
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
    MassProperties skew = cube();
    skew.I_BBcm_B(i, j) = skew.I_BBcm_B(j, i) = 1e-9;
    CHECK(judged("mass.inertia", skew).outcome == Outcome::fails);
    CHECK(judged("mass.possible", skew).outcome == Outcome::holds);
  }
}

TEST_CASE("mass: no mass has the worst grade in each property that sees it, also in single precision") {
  for (const char* property : {"mass.mass", "mass.possible", "mass.survives"}) {
    for (const double mass : {0.0, -1.0}) {
      MassProperties none = cube();
      none.mass = mass;
      CHECK(oracle::grade(judged(property, none)) == oracle::Grade::F);
      CHECK(oracle::grade(judged(property, none, oracle::Precision::binary32)) == oracle::Grade::F);
    }
  }
}

TEST_CASE("mass.possible: what no matter can have") {
  MassProperties impossible = cube();
  impossible.I_BBcm_B = Vec3(1, 1, 3).asDiagonal();
  CHECK(judged("mass.possible", impossible).outcome == Outcome::fails);
  impossible.I_BBcm_B = Vec3(-1, 1, 1).asDiagonal();
  CHECK(judged("mass.possible", impossible).outcome == Outcome::fails);
  impossible = cube();
  impossible.I_BBcm_B(0, 1) = 0.1;
  CHECK(judged("mass.possible", impossible).outcome == Outcome::fails);
  impossible = cube();
  impossible.mass = 0;
  CHECK(judged("mass.possible", impossible).outcome == Outcome::fails);
}

TEST_CASE("mass: an entry for each movable body, none for a fixed one") {
  tests::FixedSubject subject;
  subject.said_mass = Masses{cube()};
  CHECK(properties::find("mass.mass").check(tests::scene("cubes that share a face"), subject).defect ==
        Defect::wrong_mass);
  subject.said_mass = Masses{cube(), std::nullopt};
  CHECK(properties::find("mass.mass").check(tests::scene("cubes that share a face"), subject).defect ==
        Defect::wrong_mass);
}

TEST_CASE("mass: infinity is no fault where the exact mass is beyond the subject's numbers, and is one below") {
  Scene scene = tests::scene("cubes that share a face");
  for (Body& body : scene.bodies) body.shape = Box{Vec3::Constant(0x1p100)}, body.mass = Density{1};
  tests::FixedSubject subject;
  MassProperties infinite = cube();
  infinite.mass = std::numeric_limits<double>::infinity();
  subject.said_mass = Masses{infinite, infinite};
  for (const char* property : {"mass.survives", "mass.mass", "mass.repeats"}) {
    subject.introduced.precision = oracle::Precision::binary32;
    CHECK(properties::find(property).check(scene, subject).outcome == Outcome::outside);
    subject.introduced.precision = oracle::Precision::binary64;
    CHECK(properties::find(property).check(scene, subject).outcome == Outcome::fails);
  }
}
