// The size of a fault beside its scene, and that a smaller scene is shown only if the fault is as large there.
#include "app/trial/fault_size.h"

#include <cmath>

#include "app/trial/smallest.h"
#include "oracle/truth/truth.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

using oracle::Finding;
using oracle::Precision;

Scene balls(double p) {
  Scene scene;
  scene.bodies.assign(2, Body{"", Sphere{1}, {}, {}, {}, {}});
  scene.bodies[1].X_WB.p_WB.x() = p;
  return scene;
}

Finding fault(double error, double allowed, const std::string& unit) {
  Finding finding;
  finding.outcome = oracle::Outcome::fails;
  finding.defect = oracle::Defect::too_far;
  finding.error = error;
  finding.allowed = allowed;
  finding.unit = unit;
  return finding;
}

TEST_CASE("A fault has a size beside what is allowed, and beside the lengths and speeds of the scene") {
  const FaultSize ulps = fault_size(fault(0x1p33, 256, "ulps of the scene's scale"), balls(3), Precision::binary64);
  CHECK(ulps.over_allowance == 0x1p25);
  CHECK(ulps.over_scene == 0x1p-20);
  CHECK(fault_size(fault(8, 0, "ulps of the mass"), balls(3), Precision::binary32).over_scene == 0x1p-21);
  CHECK(fault_size(fault(8, 0, "ulps of the mass"), balls(3), Precision::binary32).over_allowance == 8);
  CHECK(fault_size(fault(1, 0.5, "m"), balls(3), Precision::binary64).over_scene == 0.25);
  Scene moving = balls(3);
  moving.bodies[0].velocity.v_WBcm.y() = 4;
  CHECK(fault_size(fault(1, 0.5, "m/s"), moving, Precision::binary64).over_scene == 0.25);
  CHECK(fault_size(fault(1, 0, oracle::without_size), moving, Precision::binary64).over_allowance == 0);
}

TEST_CASE("By an allowance as large as what is compared nothing is measured") {
  // What an engine was accused of whose bodies were all at rest: 1.1e-16 m/s for 0.
  CHECK_FALSE(is_measurable(fault(2e307, 2.6e300, "ulps of the impact's energy norm"), Precision::binary64));
  CHECK_FALSE(is_measurable(fault(HUGE_VAL, HUGE_VAL, "m"), Precision::binary64));
  CHECK_FALSE(is_measurable(fault(0x1p26, 0x1p25, "ulps of the scene's scale"), Precision::binary32));
  CHECK(is_measurable(fault(0x1p26, 0x1p25, "ulps of the scene's scale"), Precision::binary64));
  CHECK(is_measurable(Finding{}, Precision::binary64));
}

/// Says a distance that is wrong by 2^17 ulps of a scale of 4 where the second ball is at an odd place, else by 2^9.
class ForgetsItsFault : public oracle::Subject {
 public:
  const oracle::Card& card() const override { return card_; }
  Answer<Distance> distance(const Scene& scene) override {
    const double x = scene.bodies[1].X_WB.p_WB.x();
    Distance said;
    said.verdict = Verdict::separated;
    said.distance = oracle::truth::distance(scene).distance.hi + (x == std::floor(x) ? 0x1p-42 : 0x1p-34);
    return said;
  }

 private:
  oracle::Card card_{"forgetful", "1", Precision::binary64, {"distance"}, false, 0, "", "", {}};
};

TEST_CASE("The minimiser does not cut the fault down with the scene") {
  ForgetsItsFault subject;
  const properties::Property& property = properties::find("distance.value");
  const Scene scene = balls(3.640625);  // 233/64
  const Finding found = property.check(scene, subject);
  REQUIRE(found.outcome == oracle::Outcome::fails);
  REQUIRE(property.check(balls(3), subject).outcome == oracle::Outcome::fails);
  REQUIRE(oracle::grade(found) == oracle::grade(property.check(balls(3), subject)));
  const oracle::Case smallest = smallest_case({"family", 0, scene, found}, property, subject, 1, {.budget = 200});
  CHECK(smallest.finding.outcome == oracle::Outcome::fails);
  CHECK(smallest.finding.error >= found.error);
  CHECK(oracle::size_of(smallest.scene).significant_bits_max < oracle::size_of(scene).significant_bits_max);
  CHECK(as_large(fault_size(smallest.finding, smallest.scene, Precision::binary64),
                 fault_size(found, scene, Precision::binary64)));
}

}  // namespace
}  // namespace touchstone::app
