// The smallest scene that shows a fault, where smaller ones are no valid question.
#include "app/trial/smallest.h"

#include "model/input_error.h"
#include "oracle/judge/judge.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

/// Never asked.
class Silent : public oracle::Subject {
 public:
  const oracle::Card& card() const override { return card_; }

 private:
  oracle::Card card_{"silent", "1", oracle::Precision::binary64, {"distance"}, false, 0, "", "", {}};
};

TEST_CASE("A smaller scene that is refused as bad input is not the smallest case") {
  int refused = 0;
  const properties::Property wide{"distance.wide",
                                  "distance",
                                  {},
                                  "no body is wider than a metre",
                                  [&](const Scene& scene, oracle::Subject&) -> oracle::Finding {
                                    const double radius = std::get<Sphere>(scene.bodies[0].shape).radius;
                                    if (radius <= 1) {
                                      ++refused;
                                      throw InputError("radius", "expected more than a metre");
                                    }
                                    return oracle::judge::wrong(oracle::Defect::wrong_box, "wide", "narrow");
                                  }};
  Scene scene;
  scene.bodies.assign(1, Body{"", Sphere{640.25}, {}, {}, {}, {}});
  Silent subject;
  const oracle::Case smallest =
      smallest_case({"family", 0, scene, wide.check(scene, subject)}, wide, subject, 1, {.budget = 200});
  CHECK(smallest.finding.outcome == oracle::Outcome::fails);
  CHECK(refused > 0);
  CHECK(std::get<Sphere>(smallest.scene.bodies[0].shape).radius > 1);
}

}  // namespace
}  // namespace touchstone::app
