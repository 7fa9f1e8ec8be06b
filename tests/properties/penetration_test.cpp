// The outcomes of the penetration properties, for answers computed by hand.
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;

namespace {

oracle::Finding judged(const std::string& property, const std::string& scene, Answer<Penetration> said) {
  tests::FixedSubject subject;
  subject.said_penetration = std::move(said);
  return properties::find(property).check(tests::scene(scene), subject);
}

Penetration deep(double depth, const Vec3& nhat_BA_W = -Vec3::UnitY()) {
  return {Verdict::overlapping, depth, nhat_BA_W};
}

const std::string overlapping_cubes =
    "cubes overlapping along y";  // B at (0.25, 1.5, 0.5): depth 0.5, A separates towards -y

}  // namespace

TEST_CASE("penetration.depth: shallow, overdeep, and 0 unless overlapping") {
  CHECK(judged("penetration.depth", overlapping_cubes, deep(0.5)).outcome == Outcome::holds);
  CHECK(judged("penetration.depth", overlapping_cubes, deep(0.499)).defect == Defect::shallow);
  CHECK(judged("penetration.depth", overlapping_cubes, deep(1.5)).defect == Defect::overdeep);
  CHECK(judged("penetration.depth", "cubes apart along y", deep(0)).outcome == Outcome::holds);
  CHECK(judged("penetration.depth", "cubes apart along y", deep(0.1)).defect == Defect::overdeep);
  CHECK(judged("penetration.depth", overlapping_cubes, Penetration{}).outcome == Outcome::abstains);
}

TEST_CASE("penetration: a declared slop, and a margin of each body, are granted") {
  const auto outcome = [](double depth, const oracle::DistanceTolerance& declared) {
    tests::FixedSubject subject;
    subject.introduced.distance_tolerance = declared;
    subject.said_penetration = deep(depth);
    return properties::find("penetration.depth").check(tests::scene(overlapping_cubes), subject).outcome;
  };
  CHECK(outcome(0.49, {.slop = 0.011}) == Outcome::holds);
  CHECK(outcome(0.49, {.slop = 0.009}) == Outcome::fails);
  CHECK(outcome(0.52, {.margin = 0.011}) == Outcome::holds);
  CHECK(outcome(0.52, {.margin = 0.009}) == Outcome::fails);
}

TEST_CASE("penetration.separates: only a move that clears the bodies") {
  CHECK(judged("penetration.separates", overlapping_cubes, deep(0.5)).outcome == Outcome::holds);
  CHECK(judged("penetration.separates", overlapping_cubes, deep(1.75, -Vec3::UnitX())).outcome ==
        Outcome::holds);  // a long move, but it separates the bodies
  CHECK(judged("penetration.separates", overlapping_cubes, deep(0.5, Vec3::UnitY())).defect == Defect::wrong_normal);
  CHECK(judged("penetration.separates", overlapping_cubes, deep(0.4)).defect == Defect::wrong_normal);
  CHECK(judged("penetration.separates", "cubes apart along y", deep(0)).outcome == Outcome::outside);
}

TEST_CASE("penetration.separates: also of an answer without a verdict") {
  Penetration said = deep(0.5, Vec3::UnitY());
  said.verdict.reset();
  CHECK(judged("penetration.separates", overlapping_cubes, said).defect == Defect::wrong_normal);
  said = deep(0.5, Vec3(0, -2, 0));
  said.verdict.reset();
  CHECK(judged("penetration.unit_direction", overlapping_cubes, said).outcome == Outcome::fails);
}

TEST_CASE("penetration.unit_direction: of length 1 to 104 ulps: normalised, and turned by two poses") {
  CHECK(judged("penetration.unit_direction", overlapping_cubes, deep(0.5)).outcome == Outcome::holds);
  CHECK(judged("penetration.unit_direction", overlapping_cubes, deep(0.5, Vec3(0, -1 - 104 * 0x1p-53, 0))).outcome ==
        Outcome::holds);
  CHECK(judged("penetration.unit_direction", overlapping_cubes, deep(0.5, Vec3(0, -1 - 106 * 0x1p-53, 0))).outcome ==
        Outcome::fails);
  CHECK(judged("penetration.unit_direction", overlapping_cubes, deep(0.5, Vec3(0, -2, 0))).defect ==
        Defect::wrong_normal);
}

TEST_CASE("penetration.consistent: no depth without overlap") {
  CHECK(judged("penetration.consistent", overlapping_cubes, deep(0.5)).outcome == Outcome::holds);
  CHECK(judged("penetration.consistent", overlapping_cubes, Penetration{Verdict::separated, 0.0, {}}).outcome ==
        Outcome::holds);
  CHECK(judged("penetration.consistent", overlapping_cubes, Penetration{Verdict::separated, 0.5, {}}).outcome ==
        Outcome::fails);
}

TEST_CASE("penetration: the depth of compounds is nobody's business") {
  for (const properties::Property& property : properties::all()) {
    if (property.query != "penetration") continue;
    CHECK(judged(property.id, "two parts around a sphere", deep(1)).outcome == Outcome::outside);
  }
}
