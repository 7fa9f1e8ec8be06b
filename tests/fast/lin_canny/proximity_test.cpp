// Verdict, enclosure, witnesses and width against the exact reference in hard cases, and the memory that a query
// allocates.
#include "fast/lin_canny/proximity.h"

#include <algorithm>
#include <cmath>

#include "fast/distance.h"
#include "fast/lin_canny/nearest_parts.h"
#include "fast/lin_canny/surround.h"
#include "fast/mark.h"
#include "reference/distance.h"
#include "tests/catch.h"
#include "tests/fast/allocations.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::lin_canny {
namespace {

using tests::Dice;

/// The answer for callers that follow two bodies: a walk between hulls that are prepared whole.
NearestParts followed(const Scene& scene) {
  const Solid A(scene.bodies[0].shape);
  const Solid B(scene.bodies[1].shape);
  std::vector<FeaturePair> memory(A.parts().size() * B.parts().size());
  return nearest_parts(A, CachedPose(scene.bodies[0].X_WB), B, CachedPose(scene.bodies[1].X_WB), memory);
}

void check_against_reference(const Scene& scene) {
  const reference::DistanceTruth truth = reference::distance(scene);
  const Proximity walked = followed(scene).proximity;
  REQUIRE(walked.verdict == truth.verdict);
  REQUIRE(walked.enclosure.lo <= truth.distance.lo);
  REQUIRE(walked.enclosure.hi >= truth.distance.hi);
  const Distance said = fast::distance(scene);
  REQUIRE(said.verdict == truth.verdict);
  REQUIRE(said.enclosure->lo <= truth.distance.lo);
  REQUIRE(said.enclosure->hi >= truth.distance.hi);
  REQUIRE(*said.distance >= said.enclosure->lo);
  REQUIRE(*said.distance <= said.enclosure->hi);
  REQUIRE((*said.distance > 0) == (truth.verdict == Verdict::separated));
  if (truth.verdict == Verdict::overlapping) return;
  double size = 0;
  for (const Vec3* p : {&*said.p_WCa, &*said.p_WCb}) size = std::max(size, p->lpNorm<Eigen::Infinity>());
  const double allowed = 256 * u * (size + scene.bodies[0].X_WB.p_WB.norm() + truth.distance.hi + 16);
  REQUIRE(reference::distance_to_body(scene.bodies[0], *said.p_WCa).lo <= allowed);
  REQUIRE(reference::distance_to_body(scene.bodies[1], *said.p_WCb).lo <= allowed);
}

TEST_CASE("hard pairs of all families: the exact verdict, an enclosure that holds") {
  Dice dice(21);
  for (int i = 0; i < 60 * tests::hard_families; ++i)
    check_against_reference(tests::hard_pair(i % tests::hard_families, dice));
}

TEST_CASE("gaps of a few ulps, across poses of all kinds") {
  Dice dice(22);
  for (int i = 0; i < 300; ++i) {
    const double ulps = dice.between(-3, 3);
    const double x = dice.between(1, 9);
    const Vec3 half(x, 1, 2);
    const Vec3 across(0, dice.between(-2, 2), 0);
    const double place = 2 * x;
    const double moved = place + ulps * (std::nextafter(place, 1e9) - place);
    check_against_reference(tests::pair_of({{Box{half}}, {Box{half}, Vec3(moved, 0, 0) + across}}));
  }
}

TEST_CASE("needles and plates to 1e6, scales of 1e±100, far from the origin") {
  Dice dice(23);
  for (int i = 0; i < 150; ++i) {
    const double thin = std::pow(10, -dice.between(0, 6));
    const Polytope needle = tests::stretched(tests::round_hull(dice, 10), Vec3(1, thin, thin));
    const Polytope plate = tests::stretched(tests::round_hull(dice, 10), Vec3(1, 1, thin));
    Scene scene = tests::pair_of({{needle, 2 * dice.in_cube(), tests::integer_quaternion(dice)},
                                  {plate, Vec3::Zero(), tests::integer_quaternion(dice)}});
    check_against_reference(scene);
    Scene tiny = scene;
    tests::scale(tiny, -332);
    const Distance said = fast::distance(tiny);
    const reference::DistanceTruth truth = reference::distance(tiny);
    REQUIRE(said.verdict == truth.verdict);
    REQUIRE(said.enclosure->lo <= truth.distance.lo);
    REQUIRE(said.enclosure->hi >= truth.distance.hi);
    tests::scale(scene, 332);
    const Distance large = fast::distance(scene);
    REQUIRE(large.verdict == truth.verdict);
    for (Body& body : scene.bodies) body.X_WB.p_WB = std::ldexp(1.0, -332) * body.X_WB.p_WB + Vec3(1e10, -1e9, 3);
    tests::scale(scene, -332);
    REQUIRE(fast::distance(scene).verdict == reference::distance(scene).verdict);
  }
}

TEST_CASE("compounds: the nearest parts, one body's parts in many poses") {
  Dice dice(24);
  for (int i = 0; i < 100; ++i) {
    Compound chain;
    for (int k = 0; k < 4; ++k) {
      const Pose X{3 * dice.in_cube(), tests::integer_quaternion(dice)};
      if (k == 3) chain.parts.push_back({X, Sphere{0.5}});
      if (k < 3) chain.parts.push_back({X, Box{dice.cell(1, 2)}});
    }
    const Quaternion q = tests::integer_quaternion(dice);
    check_against_reference(tests::pair_of({{chain, 6 * dice.in_cube(), q}, {chain, 6 * dice.in_cube()}}));
  }
}

/// Generic pairs, 2.1 to 3 radii apart. By bracket.h, with ρ = 1, turn_error = 18u and shift error u|Δt|, the error of
/// lo is at most 50u + 9u|Δt|, that of hi 64u + 3u|Δt| + 4u|Δt|, together 114u + 16u|Δt| < 162u; and the witnesses are
/// at most another 8u too far apart. The scene's scale is |Δt|/2 + ρ here, or less: in its ulps (2^-52 of it) the width
/// is at most 85/(1.05 + 1/√3) < 53.
TEST_CASE("the width of generic enclosures") {
  Dice dice(25);
  std::vector<double> widths;
  for (int i = 0; i < 500; ++i) {
    const Vec3 half_apart = (1.05 + 0.45 * dice.unit()) * dice.in_cube().normalized();
    const Quaternion q = tests::integer_quaternion(dice);
    const Scene scene =
        tests::pair_of({{tests::round_hull(dice, 20), half_apart, q}, {tests::round_hull(dice, 20), -half_apart}});
    const Distance said = fast::distance(scene);
    REQUIRE(said.verdict == Verdict::separated);
    const double scale = half_apart.lpNorm<Eigen::Infinity>() + 1;
    widths.push_back((said.enclosure->hi - said.enclosure->lo) / (0x1p-52 * scale));
  }
  std::ranges::sort(widths);
  CHECK(widths.back() <= 53);
  INFO("median " << widths[widths.size() / 2] << ", greatest " << widths.back());
  CHECK(widths[widths.size() / 2] <= 40);
}

// Its features are shorter than the rounding error, so which of them is nearest is no matter of the direction.
TEST_CASE("a speck beside a giant needs no exact arithmetic") {
  Dice dice(29);
  const MarkCounts before = mark_counts;
  for (int i = 0; i < 200; ++i) {
    const Polytope giant = tests::stretched(tests::round_hull(dice, 6), Vec3::Constant(0x1p62));
    const Vec3 apart = (0x1.2p62 + 0x1p60 * dice.unit()) * dice.in_cube().normalized();
    const Quaternion p{dice.unit(), dice.unit() - 0.5, dice.unit() - 0.5, dice.unit() - 0.5}, q{1, 2, dice.unit(), 0.5};
    check_against_reference(tests::pair_of({{tests::round_hull(dice, 9), Vec3::Zero(), p}, {giant, apart, q}}));
  }
  CHECK(marks_since(before)[static_cast<std::size_t>(Mark::exact_proximity)] == 0);
}

TEST_CASE("clear overlap is proved in doubles, by a point of both, contact and gaps never are") {
  Dice dice(27);
  int proved = 0;
  int overlapping = 0;
  for (int i = 0; i < 30 * tests::hard_families; ++i) {
    const Scene scene = tests::hard_pair(i % tests::hard_families, dice);
    if (scene.bodies[0].shape.index() == 3 || scene.bodies[1].shape.index() == 3) continue;
    const Solid A(scene.bodies[0].shape);
    const Solid B(scene.bodies[1].shape);
    const Vec3& p_WA = scene.bodies[0].X_WB.p_WB;
    const PosedHull placed_A = posed_hull(A.parts()[0], CachedPose(scene.bodies[0].X_WB), p_WA);
    const PosedHull placed_B = posed_hull(B.parts()[0], CachedPose(scene.bodies[1].X_WB), p_WA);
    const std::optional<Vec3> common = common_point(placed_A, placed_B);
    const reference::DistanceTruth truth = reference::distance(scene);
    overlapping += truth.certificate.cores == Verdict::overlapping;
    if (!common) continue;
    ++proved;
    REQUIRE(truth.certificate.cores == Verdict::overlapping);
    const double allowed = 256 * u * (p_WA.norm() + A.parts()[0].reach + B.parts()[0].reach);
    REQUIRE(reference::distance_to_body(scene.bodies[0], p_WA + *common).lo <= allowed);
    REQUIRE(reference::distance_to_body(scene.bodies[1], p_WA + *common).lo <= allowed);
  }
  CHECK(overlapping > 50);
  CHECK(2 * proved > overlapping);
}

TEST_CASE("a tracked query asks for no memory") {
  Dice dice(26);
  Scene scene = tests::pair_of({{tests::round_hull(dice, 50), Vec3(2.5, 0, 0)}, {tests::round_hull(dice, 50)}});
  const Solid A(scene.bodies[0].shape);
  const Solid B(scene.bodies[1].shape);
  FeaturePair memory;
  double sum = 0;
  const std::size_t before = tests::allocations();
  for (int frame = 0; frame < 200; ++frame) {
    const Pose X{Vec3(2.5, 0.01 * frame, 0), {1, 0.02 * frame, 0, 0.01 * frame}};
    sum += proximity(A.parts()[0], CachedPose(X), B.parts()[0], CachedPose(Pose{}), memory).distance;
  }
  CHECK(tests::allocations() == before);
  CHECK(sum > 0);
}

TEST_CASE("a query that is asked once prepares nothing: its allocations do not grow with the shapes") {
  Dice dice(28);
  const auto allocations_of = [&](int vertices, double apart) {
    Scene scene =
        tests::pair_of({{tests::round_hull(dice, vertices), Vec3(apart, 0, 0)}, {tests::round_hull(dice, vertices)}});
    for (Body& body : scene.bodies) std::get<Polytope>(body.shape).faces.clear();  // they are not read
    const std::size_t before = tests::allocations();
    const Distance said = fast::distance(scene);
    const std::size_t count = tests::allocations() - before;
    CHECK(said.verdict == (apart > 2 ? Verdict::separated : Verdict::overlapping));
    return count;
  };
  // Vertices and parts of two bodies, and two features.
  for (const int vertices : {8, 50, 200}) CHECK(allocations_of(vertices, 2.5) <= 6);
  for (const int vertices : {8, 50, 200}) CHECK(allocations_of(vertices, 0.25) <= 4);
}

TEST_CASE("a query that is asked once names all vertices where a plane between the bodies would touch them") {
  const Polytope spike{{Vec3(0, 0, 0), Vec3(-1, 1, 4), Vec3(1, 1, 4), Vec3(0, -1, 4)}, {}};
  const Distance over_a_face = fast::distance(tests::pair_of({{Box{Vec3(2, 1, 1)}}, {spike, Vec3(0.5, 0.125, 2)}}));
  CHECK(over_a_face.feature_A->vertices == std::vector{4, 5, 6, 7});
  CHECK(over_a_face.feature_B->vertices == std::vector{0});
  CHECK(over_a_face.distance == 1);
  const Distance under_it = fast::distance(tests::pair_of({{spike, Vec3(0.5, 0.125, 2)}, {Box{Vec3(2, 1, 1)}}}));
  CHECK(under_it.feature_A->vertices == std::vector{0});
  CHECK(under_it.feature_B->vertices == std::vector{4, 5, 6, 7});
  const Distance beside_an_edge = fast::distance(tests::pair_of({{Box{Vec3(2, 1, 1)}}, {spike, Vec3(0.5, 4, 5)}}));
  CHECK(beside_an_edge.feature_A->vertices == std::vector{6, 7});
  CHECK(beside_an_edge.distance == 5);
  const Distance over_a_diagonal = fast::distance(tests::pair_of({{Box{Vec3(2, 1, 1)}}, {spike, Vec3(1, 0.5, 2)}}));
  CHECK(over_a_diagonal.feature_A->vertices == std::vector{4, 5, 6, 7});
  const Distance parallel = fast::distance(tests::pair_of({{Box{Vec3(2, 1, 1)}}, {Box{Vec3(1, 9, 1)}, Vec3(0, 0, 4)}}));
  CHECK(parallel.feature_A->vertices == std::vector{4, 5, 6, 7});
  CHECK(parallel.feature_B->vertices == std::vector{0, 1, 2, 3});
}

TEST_CASE("beyond the range of doubles it says so") {
  const Scene scene = tests::pair_of(
      {{Box{Vec3(1, 1, 1)}, Vec3(1e308, 1e308, 1e308)}, {Box{Vec3(1, 1, 1)}, Vec3(-1e308, -1e308, -1e308)}});
  CHECK_THROWS_AS(fast::distance(scene), std::range_error);
}

}  // namespace
}  // namespace touchstone::fast::lin_canny
