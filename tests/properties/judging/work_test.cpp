// The outcomes of the properties about work, for counts that are made by hand.
#include <Eigen/Geometry>

#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;
using oracle::Work;

namespace {

/// Two cubes with 8 vertices each.
oracle::Finding judged(const Answer<Work>& counts, std::vector<oracle::WorkLimit> limits,
                       const std::string& scene = "cubes that share a face",
                       const std::string& property = "distance.work") {
  tests::FixedSubject subject;
  subject.introduced.work_limits = std::move(limits);
  subject.said_work = counts;
  return properties::find(property).check(tests::scene(scene), subject);
}

Outcome outcome(const Work& counts, std::vector<oracle::WorkLimit> limits) {
  return judged(counts, std::move(limits)).outcome;
}

}  // namespace

TEST_CASE("work: a count is at most what is promised, for sizes of the scene and other counts") {
  CHECK(outcome({{"step", 5}}, {{"distance", "step", 5}}) == Outcome::holds);
  CHECK(outcome({{"step", 6}}, {{"distance", "step", 5}}) == Outcome::fails);
  CHECK(outcome({{"step", 21}}, {{"distance", "step", 5, {{"vertices", 1}}}}) == Outcome::holds);
  CHECK(outcome({{"step", 22}}, {{"distance", "step", 5, {{"vertices", 1}}}}) == Outcome::fails);
  CHECK(outcome({{"step", 6}, {"walk", 2}}, {{"distance", "step", 0, {{"walk", 3}}}}) == Outcome::holds);
  CHECK(outcome({{"step", 7}, {"walk", 2}}, {{"distance", "step", 0, {{"walk", 3}}}}) == Outcome::fails);
  CHECK(outcome({{"step", 9}}, {{"distance", "step", 5, {{"bodies", 2}}}}) == Outcome::holds);
  CHECK(outcome({{"step", 8}}, {{"distance", "step", 5, {{"pairs", 3}}}}) == Outcome::holds);
  CHECK(outcome({{"step", 9}}, {{"distance", "step", 5, {{"pairs", 3}}}}) == Outcome::fails);
  CHECK(outcome({{"step", 1}}, {{"distance", "step", 0, {{"pixels", 1}, {"samples", 1}, {"frames", 1}}}}) ==
        Outcome::fails);
}

TEST_CASE("work: sizes of a motion and of slender bodies") {
  tests::FixedSubject subject;
  Scene scene = tests::scene("cubes that share a face");
  scene.bodies[0].velocity.w_WB = {0, 3, 4};
  scene.motion.emplace().sample_times = {0.5, 2};
  scene.bodies[1].shape = Box{{4, 0.5, 2}};  // 9 m from corner to corner, 1 m thick
  const auto outcome_of = [&](double count, oracle::WorkLimit limit) {
    subject.introduced.work_limits = {std::move(limit)};
    subject.said_work = Work{{"step", static_cast<std::uint64_t>(count)}};
    return properties::find("time_of_impact.work").check(scene, subject).outcome;
  };
  CHECK(outcome_of(10, {"time_of_impact", "step", 0, {{"radians", 1}}}) == Outcome::holds);
  CHECK(outcome_of(11, {"time_of_impact", "step", 0, {{"radians", 1}}}) == Outcome::fails);
  CHECK(outcome_of(2, {"time_of_impact", "step", 0, {{"seconds", 1}}}) == Outcome::holds);
  CHECK(outcome_of(3, {"time_of_impact", "step", 0, {{"seconds", 1}}}) == Outcome::fails);
  CHECK(outcome_of(4, {"time_of_impact", "step", 0, {{"body_seconds", 1}}}) == Outcome::holds);
  CHECK(outcome_of(5, {"time_of_impact", "step", 0, {{"body_seconds", 1}}}) == Outcome::fails);
  CHECK(outcome_of(9, {"time_of_impact", "step", 0, {{"aspect", 1.01}}}) == Outcome::holds);
  CHECK(outcome_of(10, {"time_of_impact", "step", 0, {{"aspect", 1.01}}}) == Outcome::fails);
}

TEST_CASE("work: where nothing is promised, one step is too many, what is not counted is not taken") {
  CHECK(outcome({}, {{"distance", "exact"}}) == Outcome::holds);
  const oracle::Finding finding = judged({Work{{"exact", 1}}}, {{"distance", "exact"}});
  CHECK(finding.outcome == Outcome::fails);
  CHECK(finding.defect == Defect::too_much_work);
  CHECK(finding.observed == "1 of exact");
  CHECK(finding.expected == "at most 0");
}

TEST_CASE("work: the finding is about the count that exceeds its limit most") {
  const oracle::Finding finding =
      judged({Work{{"a", 6}, {"b", 8}, {"c", 1}}}, {{"distance", "a", 5}, {"distance", "b", 4}, {"distance", "c", 9}});
  CHECK(finding.observed == "8 of b");
  CHECK(finding.error == 2);
  CHECK(finding.allowed == 1);
}

TEST_CASE("work: a promise about another query says nothing about this one") {
  CHECK(outcome({{"step", 6}}, {{"penetration", "step", 5}}) == Outcome::outside);
  CHECK(outcome({{"step", 6}}, {}) == Outcome::outside);
}

TEST_CASE("work: a promise about generic placements is about their sum, and about two convex bodies") {
  CHECK(outcome({{"step", 2}}, {{"distance", "step", 6, {}, 3}}) == Outcome::holds);
  CHECK(outcome({{"step", 2}}, {{"distance", "step", 5, {}, 3}}) == Outcome::fails);
  CHECK(outcome({{"step", 2}}, {{"distance", "step", 5, {}, 3}, {"distance", "step", 1}}) == Outcome::fails);
  CHECK(judged({Work{{"step", 2}}}, {{"distance", "step", 5, {}, 3}}, "the second part is nearer").outcome ==
        Outcome::outside);
}

// The mean of a double pyramid's vertices is on its planes of symmetry, and a speck there would be at the border of a
// tetrahedron of its vertices.
TEST_CASE("work: a speck is placed inside a symmetric body, but not on its planes of symmetry") {
  struct : tests::FixedSubject {
    std::vector<Scene> asked;
    Answer<Work> work(const std::string&, const Scene& scene) override {
      asked.push_back(scene);
      return Work{};
    }
  } subject;
  subject.introduced.work_limits = {{"penetration", "step", 1, {}, 16}};
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = Sphere{0x1p-33};
  scene.bodies[1].shape =
      Polytope{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
               {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  REQUIRE(properties::find("penetration.work").check(scene, subject).outcome == Outcome::holds);
  REQUIRE(subject.asked.size() == 16);
  for (const Scene& placed : subject.asked) {
    const Pose& at = placed.bodies[1].X_WB;
    const Eigen::Quaterniond turn = Eigen::Quaterniond(at.q_WB.w, at.q_WB.x, at.q_WB.y, at.q_WB.z).normalized();
    const Vec3 seen = turn.inverse() * Vec3(placed.bodies[0].X_WB.p_WB - at.p_WB);
    CHECK(seen.lpNorm<1>() < 1);
    CHECK(seen.cwiseAbs().minCoeff() > 0x1p-20);
  }
}

TEST_CASE("work: a scene without a part that the query needs is outside") {
  CHECK(judged(Work{{"step", 6}}, {{"impulse", "step", 5}}, "cubes that share a face", "impulse.work").outcome ==
        Outcome::outside);
  CHECK(judged(Work{{"step", 6}}, {{"simulation", "step", 5}}, "cubes that share a face", "simulation.work").outcome ==
        Outcome::outside);
}

TEST_CASE("work: no answer is no promise kept") {
  const oracle::Finding finding = judged(Abstains{"no"}, {{"distance", "step", 5}});
  CHECK(finding.outcome == Outcome::fails);
  CHECK(finding.defect == Defect::refused);
  CHECK(judged(Breaks{Breaks::Kind::threw, "no"}, {{"distance", "step", 5}}).outcome == Outcome::breaks);
}

TEST_CASE("work: no promise is broken by no answer about bodies in constraint that start at different times") {
  tests::FixedSubject subject;
  subject.introduced.work_limits = {{"constraint", "step", 5}};
  subject.said_work = Abstains{"they start at different times"};
  Scene scene = tests::scene("cubes that share a face");
  scene.motion.emplace().sample_times = {1};
  const auto outcome_now = [&] { return properties::find("constraint.work").check(scene, subject).outcome; };
  CHECK(outcome_now() == Outcome::fails);
  scene.motion->start_times = {0, 0.5};
  CHECK(outcome_now() == Outcome::abstains);
}
