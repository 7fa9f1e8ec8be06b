// The outcomes of the distance properties, for answers computed by hand.
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

oracle::Finding judged(const std::string& property, const std::string& scene, Answer<Distance> said,
                       oracle::Card card = {}) {
  tests::FixedSubject subject;
  subject.introduced = card;
  subject.said_distance = std::move(said);
  return properties::find(property).check(tests::scene(scene), subject);
}

Distance verdict(Verdict said) {
  Distance answer;
  answer.verdict = said;
  return answer;
}

Distance value(double said) {
  Distance answer;
  answer.distance = said;
  return answer;
}

oracle::Card in(oracle::Precision precision) {
  oracle::Card card;
  card.precision = precision;
  return card;
}

oracle::Card knowing_touching() {
  oracle::Card card;
  card.knows_touching = true;
  return card;
}

const std::string apart = "cubes apart along y";          // A about the origin, B at (0.5, 2.25, 0.25): distance 0.25
const std::string touching = "cubes that share a face";   // B at (0, 2, 0.5)
const std::string overlap = "cubes overlapping along y";  // B at (0.25, 1.5, 0.5): depth 0.5
constexpr double S = 2.25 + 1.7320508075688772;

}  // namespace

TEST_CASE("distance.verdict: a wrong verdict is a phantom or a miss, with the margin in metres and its proof") {
  const auto phantom = judged("distance.verdict", apart, verdict(Verdict::overlapping));
  CHECK(phantom.outcome == Outcome::fails);
  CHECK(phantom.defect == Defect::phantom);
  CHECK(phantom.margin == Interval{0.25, 0.25});
  CHECK_FALSE(phantom.certificate.empty());
  CHECK(phantom.error == Approx(0.25 / (S * 0x1p-53)));
  CHECK(oracle::grade(phantom) == oracle::Grade::F);
  const auto missed = judged("distance.verdict", overlap, verdict(Verdict::separated));
  CHECK(missed.defect == Defect::missed);
  CHECK(missed.margin == Interval{0.5, 0.5});
}

// A's box and its ball are both 1/2 above B; the gap of the ball's core is larger by its radius.
TEST_CASE("distance.features: of parts that are equally near either may be named, whatever their radii") {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = Compound{{{{{0, 0, 1}, {}}, Box{Vec3::Ones()}}, {{{5, 0, 2}, {}}, Sphere{2}}}};
  scene.bodies[1].shape = Box{Vec3(8, 8, 1)};
  scene.bodies[1].X_WB.p_WB = {0, 0, -1.5};
  tests::FixedSubject subject;
  const auto outcome = [&](const Feature& of_A) {
    Distance said = value(0.5);
    said.feature_A = of_A;
    said.feature_B = Feature{0, {4, 5, 6, 7}};
    subject.said_distance = said;
    return properties::find("distance.features").check(scene, subject).outcome;
  };
  CHECK(outcome({0, {0, 1, 2, 3}}) == Outcome::holds);
  CHECK(outcome({1, {0}}) == Outcome::holds);
  std::get<Compound>(scene.bodies[0].shape).parts[1].X_BP.p_WB.z() += 0x1p-20;
  CHECK(outcome({1, {0}}) == Outcome::fails);
}

TEST_CASE("distance.verdict: a two-valued subject may say either where bodies touch, one that knows touching may not") {
  for (const Verdict said : {Verdict::separated, Verdict::overlapping}) {
    CHECK(judged("distance.verdict", touching, verdict(said)).outcome == Outcome::holds);
    const auto strict = judged("distance.verdict", touching, verdict(said), knowing_touching());
    CHECK(strict.outcome == Outcome::fails);
    CHECK(strict.defect == (said == Verdict::separated ? Defect::missed : Defect::phantom));
  }
}

TEST_CASE("distance.verdict: a two-valued subject may say either where compounds overlap by less than rounding") {
  Body body;
  body.shape = Compound{{Part{{}, Box{Vec3::Ones()}}, Part{{{0, -2, 0}, {}}, Box{Vec3::Ones()}}}};
  Scene scene;
  scene.bodies.assign(2, body);
  scene.bodies[1].X_WB.p_WB.y() = 4 - 0x1p-50;
  tests::FixedSubject subject;
  for (const Verdict said : {Verdict::separated, Verdict::overlapping}) {
    subject.said_distance = verdict(said);
    CHECK(properties::find("distance.verdict").check(scene, subject).outcome == Outcome::holds);
  }
}

TEST_CASE("distance.verdict: compounds, whose depth is unknown, have a certified margin") {
  const auto missed = judged("distance.verdict", "two parts around a sphere", verdict(Verdict::separated));
  CHECK(missed.outcome == Outcome::fails);
  CHECK(missed.margin->lo > 0);
  CHECK(missed.margin->lo < 2);
  CHECK(missed.margin->hi == std::numeric_limits<double>::infinity());
}

TEST_CASE("distance.value: held against 250 ulps of the scene's scale, in the subject's own precision") {
  const double u = 0x1p-53;
  CHECK(judged("distance.value", apart, value(0.25 + 249 * u * S)).outcome == Outcome::holds);
  const auto far = judged("distance.value", apart, value(0.25 + 251 * u * S));
  CHECK(far.outcome == Outcome::fails);
  CHECK(far.defect == Defect::too_far);
  CHECK(far.error == Approx(251).epsilon(0.01));
  CHECK(far.allowed == Approx(250));
  CHECK(oracle::grade(far) == oracle::Grade::B);
  CHECK(judged("distance.value", apart, value(0.25 - 1e-6)).defect == Defect::too_near);
  CHECK(judged("distance.value", apart, value(0.25 + 1e-6), in(oracle::Precision::binary32)).outcome == Outcome::holds);
  CHECK(judged("distance.value", apart, value(0.25 + 9 * u * S), in(oracle::Precision::exact)).outcome ==
        Outcome::fails);
}

TEST_CASE("what is no answer is passed on") {
  CHECK(judged("distance.value", apart, Abstains{"no"}).outcome == Outcome::abstains);
  CHECK(judged("distance.value", apart, verdict(Verdict::separated)).outcome == Outcome::abstains);
  const auto hung = judged("distance.value", apart, Breaks{Breaks::Kind::hung, "2 s"});
  CHECK(hung.outcome == Outcome::breaks);
  CHECK(hung.defect == Defect::hung);
  CHECK(hung.why == "2 s");
  const auto nan = judged("distance.value", apart, value(std::numeric_limits<double>::quiet_NaN()));
  CHECK(nan.outcome == Outcome::fails);
  CHECK(nan.defect == Defect::not_finite);
}

TEST_CASE("outside: not a pair, or not exact in binary32") {
  CHECK(judged("distance.value", "a needle", value(0)).outcome == Outcome::outside);
  const oracle::Card single = in(oracle::Precision::binary32);
  CHECK(judged("distance.value", "cubes 2^-32 apart", value(0x1p-32), single).outcome == Outcome::outside);
  CHECK(judged("distance.value", "cubes 2^-32 apart", value(0x1p-32)).outcome == Outcome::holds);
}

TEST_CASE("distance.witnesses: any closest pair, but no other") {
  Distance said;
  said.p_WCa = Vec3(0.5, 1, 0.25), said.p_WCb = Vec3(0.5, 1.25, 0.25);
  CHECK(judged("distance.witnesses_on_bodies", apart, said).outcome == Outcome::holds);
  CHECK(judged("distance.witnesses_apart", apart, said).outcome == Outcome::holds);
  said.p_WCa = Vec3(-0.5, 1, 0.25);  // on A, but too far from the other witness
  CHECK(judged("distance.witnesses_on_bodies", apart, said).outcome == Outcome::holds);
  CHECK(judged("distance.witnesses_apart", apart, said).outcome == Outcome::fails);
  said.p_WCa = Vec3(0.5, 1.125, 0.25);  // between the bodies: 1/8 away from A
  const auto off = judged("distance.witnesses_on_bodies", apart, said);
  CHECK(off.defect == Defect::wrong_witness);
  CHECK(off.error == Approx(0.125 / (S * 0x1p-53)));
  CHECK(judged("distance.witnesses_on_bodies", overlap, said).outcome == Outcome::outside);
}

TEST_CASE("distance.features: whole or in part, but a closest pair must be in them") {
  // A's face y = +1 is {2, 3, 6, 7}, B's face y = -1 is {0, 1, 4, 5}; they face each other, shifted by (0.5, 0.25).
  const auto features = [](std::vector<int> a, std::vector<int> b) {
    Distance said;
    said.feature_A = Feature{0, std::move(a)}, said.feature_B = Feature{0, std::move(b)};
    return judged("distance.features", apart, said);
  };
  CHECK(features({2, 3, 6, 7}, {0, 1, 4, 5}).outcome == Outcome::holds);
  CHECK(features({2, 3, 6, 7}, {0}).outcome == Outcome::holds);  // B's vertex (-0.5, 1.25, -0.75) is over A's face
  CHECK(features({3, 7}, {0, 1}).outcome == Outcome::holds);     // crossed edges
  CHECK(features({2, 3, 6, 7}, {1}).defect == Defect::wrong_feature);  // B's vertex (1.5, 1.25, -0.75) is not
  CHECK(features({2, 3}, {0, 1}).defect == Defect::wrong_feature);     // parallel edges, 0.25 apart in z as well
  CHECK(features({0}, {0}).defect == Defect::wrong_feature);
  CHECK(features({8}, {0}).defect == Defect::wrong_feature);
  CHECK(features({}, {0}).defect == Defect::wrong_feature);
}

TEST_CASE("distance.enclosure: not one bit too narrow") {
  const auto enclosure = [](double lo, double hi) {
    Distance said;
    said.enclosure = Interval{lo, hi};
    return judged("distance.enclosure", apart, said);
  };
  CHECK(enclosure(0.25, 0.25).outcome == Outcome::holds);
  CHECK(enclosure(0, 1).outcome == Outcome::holds);
  CHECK(enclosure(std::nextafter(0.25, 1), 1).defect == Defect::broken_enclosure);
  CHECK(enclosure(0, std::nextafter(0.25, 0)).defect == Defect::broken_enclosure);
}

TEST_CASE("laws hold for an answer that is the same constant, except where the law changes it") {
  Distance constant = value(0.25);
  constant.verdict = Verdict::separated;
  for (const char* law : {"symmetric", "translated", "turned", "consistent", "survives", "repeats"}) {
    CHECK(judged(std::string("distance.") + law, apart, constant).outcome == Outcome::holds);
  }
  CHECK(judged("distance.scaled", apart, constant).defect == Defect::scaled);
  CHECK(judged("distance.relabelled", apart, constant).outcome == Outcome::outside);  // boxes have no vertex list
  CHECK(judged("distance.survives", apart, value(-1)).outcome == Outcome::fails);
}

TEST_CASE("distance.consistent: two verdicts have no word for touching but separated at 0") {
  Distance said = value(0);
  said.verdict = Verdict::separated;
  CHECK(judged("distance.consistent", touching, said).outcome == Outcome::holds);
  CHECK(judged("distance.consistent", touching, said, knowing_touching()).defect == Defect::too_near);
  said.verdict = Verdict::overlapping;
  said.distance = 1e-9;
  CHECK(judged("distance.consistent", touching, said).defect == Defect::too_far);
}
