// The outcomes of the broad phase properties, for answers computed by hand.
#include <cmath>

#include "oracle/judge/grade.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;

namespace {

oracle::Finding judged(const std::string& property, const std::string& scene, Answer<PairSet> said, double margin = 0) {
  tests::FixedSubject subject;
  subject.introduced.broad_phase_margin = margin;
  subject.said_pairs = std::move(said);
  return properties::find(property).check(tests::scene(scene), subject);
}

const std::string touching = "cubes that share a face";
const std::string apart = "cubes apart along y";  // by 0.25

}  // namespace

TEST_CASE("broad_phase.misses_none: boxes that only touch are a pair") {
  CHECK(judged("broad_phase.misses_none", touching, PairSet{{0, 1}}).outcome == Outcome::holds);
  CHECK(judged("broad_phase.misses_none", touching, PairSet{{1, 0}}).outcome ==
        Outcome::holds);  // well_formed checks the form
  const auto missed = judged("broad_phase.misses_none", touching, PairSet{});
  CHECK(oracle::grade(missed) == oracle::Grade::A_minus);  // an engine that does not round outward may compute a gap
  CHECK(missed.outcome == Outcome::fails);
  CHECK(missed.defect == Defect::missed);
  CHECK(missed.margin == Interval{0, 0});
}

TEST_CASE("broad_phase.adds_none: none further apart than rounding and the margin") {
  CHECK(judged("broad_phase.adds_none", apart, PairSet{}).outcome == Outcome::holds);
  const auto phantom = judged("broad_phase.adds_none", apart, PairSet{{0, 1}});
  CHECK(phantom.defect == Defect::phantom);
  CHECK(phantom.margin == Interval{0.25, 0.25});
  CHECK(judged("broad_phase.adds_none", apart, PairSet{{0, 1}}, 0.125).outcome == Outcome::holds);
  CHECK(judged("broad_phase.adds_none", apart, PairSet{{0, 1}}, 0.1).outcome == Outcome::fails);
  // An octahedron turned by 45° reaches to 1/√2 in x, and the turned box about it to √2; a ball begins at 1.
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = Polytope{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  scene.bodies[0].X_WB.q_WB = {std::cos(std::atan(1.0) / 2), 0, 0, std::sin(std::atan(1.0) / 2)};
  scene.bodies[1].shape = Sphere{1};
  scene.bodies[1].X_WB.p_WB.x() = 2;
  tests::FixedSubject subject;
  subject.said_pairs = PairSet{{0, 1}};
  CHECK(properties::find("broad_phase.adds_none").check(scene, subject).outcome == Outcome::fails);
  subject.introduced.boxes = oracle::BoxKind::of_turned_box;
  CHECK(properties::find("broad_phase.adds_none").check(scene, subject).outcome == Outcome::holds);
  scene.bodies[1].X_WB.p_WB.x() = 2.5;
  CHECK(properties::find("broad_phase.adds_none").check(scene, subject).outcome == Outcome::fails);
}

namespace {

/// An octahedron that reaches to 4/5 in x, the turned box about it to 3/5 + 4/5, and a unit ball beside it.
Scene octahedron_and_ball(double x) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = Polytope{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  scene.bodies[0].X_WB.q_WB = {2, 0, 0, 1};
  scene.bodies[1].shape = Sphere{1};
  scene.bodies[1].X_WB.p_WB.x() = x;
  return scene;
}

/// The same, placed in one frame of a sequence.
Scene octahedron_and_ball_in_a_frame(double x) {
  Scene scene = octahedron_and_ball(x);
  scene.frames = {{{0, scene.bodies[0].X_WB}, {1, scene.bodies[1].X_WB}}};
  return scene;
}

/// Reports its pair in the world as it is given, and no pair in the turned one.
struct OfOneFrame : tests::FixedSubject {
  explicit OfOneFrame(oracle::BoxKind kind) { introduced.boxes = kind; }

  static PairSet pairs(const Pose& of_ball) { return of_ball.p_WB.x() > 0 ? PairSet{{0, 1}} : PairSet{}; }
  Answer<PairSet> broad_phase(const Scene& scene) override { return pairs(scene.bodies[1].X_WB); }
  Answer<PairHistory> pair_history(const Scene& sequence) override {
    return PairHistory{{pairs(sequence.frames[0][1].X_WB.value()), {}, {}}};
  }
};

Outcome of_one_frame(const std::string& property, const Scene& scene, oracle::BoxKind kind) {
  OfOneFrame subject(kind);
  return properties::find(property).check(scene, subject).outcome;
}

}  // namespace

TEST_CASE("broad_phase.turned: a pair is free where the boxes that a subject declares touch within rounding") {
  using oracle::BoxKind;
  const auto outcomes = [](double x, BoxKind kind) {
    const Outcome still = of_one_frame("broad_phase.turned", octahedron_and_ball(x), kind);
    CHECK(of_one_frame("broad_phase.film.turned", octahedron_and_ball_in_a_frame(x), kind) == still);
    return still;
  };
  CHECK(outcomes(2.4, BoxKind::tight) == Outcome::fails);
  CHECK(outcomes(2.4, BoxKind::of_turned_box) == Outcome::holds);
  CHECK(outcomes(2.25, BoxKind::of_turned_box) == Outcome::fails);  // these overlap, the least boxes do not
  CHECK(outcomes(2.25, BoxKind::of_ball) == Outcome::holds);        // of radius √3, about the sphere too
  CHECK(outcomes(3.5, BoxKind::of_ball) == Outcome::fails);
  CHECK(outcomes(1.75, BoxKind::of_ball) == Outcome::fails);  // the least boxes overlap
}

TEST_CASE("broad_phase.turned: a pair that touches and is lost in the turned world is graded as a missed one") {
  const auto grades = [](double x) {
    OfOneFrame subject(oracle::BoxKind::tight);
    const auto still = oracle::grade(properties::find("broad_phase.turned").check(octahedron_and_ball(x), subject));
    const Scene frame = octahedron_and_ball_in_a_frame(x);
    CHECK(oracle::grade(properties::find("broad_phase.film.turned").check(frame, subject)) == still);
    return still;
  };
  CHECK(grades(1.7999999999999998) == oracle::Grade::A_minus);  // the double below 4/5 + 1
  CHECK(grades(1.75) == oracle::Grade::D);
}

TEST_CASE("broad_phase.film.adds_none: a pair of declared boxes that overlap is none too many") {
  using oracle::BoxKind;
  const auto outcome = [](double x, BoxKind kind) {
    return of_one_frame("broad_phase.film.adds_none", octahedron_and_ball_in_a_frame(x), kind);
  };
  CHECK(outcome(2.25, BoxKind::tight) == Outcome::fails);
  CHECK(outcome(2.25, BoxKind::of_turned_box) == Outcome::holds);
  CHECK(outcome(2.5, BoxKind::of_turned_box) == Outcome::fails);
}

/// Three balls of radius 1: the second is 1 from the first, the third 0.0625.
Scene three_balls() {
  Scene scene;
  scene.bodies.resize(3);
  for (Body& body : scene.bodies) body.shape = Sphere{1};
  scene.bodies[1].X_WB.p_WB.x() = -3;
  scene.bodies[2].X_WB.p_WB.x() = 2.0625;
  return scene;
}

TEST_CASE("broad_phase: of several pairs too many the worst is judged, in a sequence too") {
  const Scene scene = three_balls();
  Scene frame = scene;
  frame.frames.emplace_back();
  for (int i = 0; i < 3; ++i) frame.frames[0].push_back({i, scene.bodies[static_cast<std::size_t>(i)].X_WB});
  tests::FixedSubject subject;
  subject.introduced.broad_phase_margin = 0.125;
  const auto outcomes = [&](const PairSet& said, Outcome outcome) {
    subject.said_pairs = said;
    subject.said_history = PairHistory{{said, {}, {}}};
    CHECK(properties::find("broad_phase.adds_none").check(scene, subject).outcome == outcome);
    CHECK(properties::find("broad_phase.film.adds_none").check(frame, subject).outcome == outcome);
  };
  outcomes({{0, 2}}, Outcome::holds);
  outcomes({{0, 1}, {0, 2}}, Outcome::fails);
}

TEST_CASE("broad_phase.film.absent: a removed body has no pair, the first or the second of one") {
  for (const int removed : {0, 1}) {
    Scene scene = three_balls();
    scene.bodies.resize(2);
    scene.frames = {{{0, scene.bodies[0].X_WB}, {1, scene.bodies[0].X_WB}}, {{removed, std::nullopt}}};
    tests::FixedSubject subject;
    subject.said_history = PairHistory{{{{0, 1}}, {}, {}}, {{}, {}, {}}};
    CHECK(properties::find("broad_phase.film.absent").check(scene, subject).outcome == Outcome::holds);
    subject.said_history = PairHistory{{{{0, 1}}, {}, {}}, {{{0, 1}}, {}, {}}};
    CHECK(properties::find("broad_phase.film.absent").check(scene, subject).defect == Defect::phantom);
  }
}

TEST_CASE("broad_phase.film: a sequence is judged in the precision that the card declares for pair_history") {
  const Scene sequence = octahedron_and_ball_in_a_frame(2.1);  // no float
  OfOneFrame subject(oracle::BoxKind::of_turned_box);
  CHECK(properties::find("broad_phase.film.adds_none").check(sequence, subject).outcome == Outcome::holds);
  subject.introduced.precision_of = {{"pair_history", oracle::Precision::binary32}};
  CHECK(properties::find("broad_phase.film.adds_none").check(sequence, subject).outcome == Outcome::outside);
}

TEST_CASE("broad_phase.well_formed: i < j of bodies, sorted, each once") {
  CHECK(judged("broad_phase.well_formed", touching, PairSet{{0, 1}}).outcome == Outcome::holds);
  for (const PairSet& bad :
       {PairSet{{1, 0}}, PairSet{{0, 1}, {0, 1}}, PairSet{{0, 2}}, PairSet{{-1, 0}}, PairSet{{0, 0}}}) {
    CHECK(judged("broad_phase.well_formed", touching, bad).outcome == Outcome::fails);
  }
}

TEST_CASE("broad_phase laws: a pair within reach is free, another is not") {
  CHECK(judged("broad_phase.translated", touching, PairSet{{0, 1}}).outcome == Outcome::holds);
  CHECK(judged("broad_phase.relabelled", touching, PairSet{{0, 1}}).outcome == Outcome::holds);
  CHECK(judged("broad_phase.repeats", touching, PairSet{{0, 1}}).outcome == Outcome::holds);
}
