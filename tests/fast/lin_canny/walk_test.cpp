// The walk: from every start to the same result, ever closer, and each of its branches on a scene made for it.
#include "fast/lin_canny/walk.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "fast/lin_canny/proximity.h"
#include "reference/distance.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::lin_canny {
namespace {

using tests::Dice;

std::vector<FeatureId> features(const Hull& hull) {
  std::vector<FeatureId> all;
  for (int v = 0; v < hull.vertex_count(); ++v) all.push_back({Kind::vertex, v});
  for (int e = 0; e < hull.edge_count(); ++e) all.push_back({Kind::edge, e});
  for (int f = 0; f < hull.face_count(); ++f) all.push_back({Kind::face, f});
  return all;
}

struct Pair {
  explicit Pair(const Scene& scene)
      : solid_A(scene.bodies[0].shape),
        solid_B(scene.bodies[1].shape),
        cached_A(scene.bodies[0].X_WB),
        cached_B(scene.bodies[1].X_WB) {}

  const Convex& A() const { return solid_A.parts()[0]; }
  const Convex& B() const { return solid_B.parts()[0]; }
  PosedHull placed_A() const { return posed_hull(A(), cached_A, cached_A.X_WB.p_WB); }
  PosedHull placed_B() const { return posed_hull(B(), cached_B, cached_A.X_WB.p_WB); }
  Proximity from(FeaturePair seed) const { return proximity(A(), cached_A, B(), cached_B, seed); }

  Solid solid_A;
  Solid solid_B;
  CachedPose cached_A;
  CachedPose cached_B;
};

Scene small_round_pair(Dice& dice, double reach) {
  const Vec3 apart = reach * dice.in_cube();
  const Quaternion q = tests::integer_quaternion(dice);
  return tests::pair_of({{tests::round_hull(dice, dice.between(4, 8)), Vec3::Zero(), q},
                         {tests::round_hull(dice, dice.between(4, 8)), apart, tests::integer_quaternion(dice)}});
}

/// How many pairs a walk may visit. There are at most |A|·|B| pairs, each visited once. The bound tested here is
/// linear: Lin and Canny observed it, but no theorem guarantees it.
std::size_t step_bound(const Hull& A, const Hull& B) { return features(A).size() + features(B).size(); }

/// A tetrahedron with an edge from (0, −2, 0) to (0, 2, 0), above or below which the rest is.
Polytope edge_along_y(double z) {
  return reference::convex_hull({Vec3(0, -2, 0), Vec3(0, 2, 0), Vec3(-1, 0, z), Vec3(1, 0, z)});
}

TEST_CASE("edges that cross at 2^-10 to 2^-38 of a radian are nearest where they cross, within rounding") {
  for (int k = 11; k < 40; ++k) {
    const double t = std::exp2(-k), tangent = 2 * t / (1 - t * t);
    const Pair pair(tests::pair_of(
        {{edge_along_y(-1), Vec3::Zero(), {}}, {edge_along_y(1), Vec3(tangent, 0, 0.5), Quaternion{1, 0, 0, t}}}));
    const Proximity found = pair.from({});
    // The places and the directions round by some 2^-49, and the crossing by that over the sine.
    CHECK((found.p_WCa - Vec3(0, 1, 0)).norm() <= 0x1p-49 / tangent);
    CHECK((found.p_WCb - Vec3(0, 1, 0.5)).norm() <= 0x1p-49 / tangent);
  }
}

TEST_CASE("from every seed one answer, nearer at each step, in few steps") {
  Dice dice(5);
  std::size_t walks = 0;
  std::size_t restarts = 0;
  int separated = 0;
  for (int i = 0; i < 1000; ++i) {
    const Scene scene = i % 3 == 0 ? tests::hard_pair(i % 6, dice) : small_round_pair(dice, 4);
    const Pair pair(scene);
    const reference::DistanceTruth truth = reference::distance(scene);
    separated += truth.verdict == Verdict::separated;
    const PosedHull A = pair.placed_A();
    const PosedHull B = pair.placed_B();
    for (const FeatureId& a : features(*A.hull)) {
      for (const FeatureId& b : features(*B.hull)) {
        std::vector<Closest> visited;
        const Walked walked = walk(A, B, {a, b}, &visited);
        ++walks;
        int ascents = 0;
        for (std::size_t k = 1; k < visited.size(); ++k) ascents += !(visited[k].squared < visited[k - 1].squared);
        REQUIRE(ascents == (walked.has_restarted ? 1 : 0));
        restarts += walked.has_restarted;
        REQUIRE(visited.size() <= step_bound(*A.hull, *B.hull));
        if (truth.verdict != Verdict::separated || truth.distance.lo < 1e-9) continue;
        REQUIRE_FALSE(walked.inside);
        REQUIRE(std::abs(std::sqrt(walked.closest.squared) - truth.distance.lo) < 1e-13 * (1 + truth.distance.lo));
      }
    }
  }
  CHECK(walks > 400'000);
  CHECK(separated > 600);
  CHECK(restarts > 100);  // the far side was reached, and left
}

TEST_CASE("from every seed the same verdict, and enclosures that hold the exact distance") {
  Dice dice(6);
  for (int i = 0; i < 4 * tests::hard_families; ++i) {
    const Scene scene = tests::hard_pair(i % tests::hard_families, dice);
    if (scene.bodies[0].shape.index() == 3 || scene.bodies[1].shape.index() == 3) continue;
    const Pair pair(scene);
    const reference::DistanceTruth truth = reference::distance(scene);
    const std::vector<FeatureId> of_A = features(pair.A().core);
    const std::vector<FeatureId> of_B = features(pair.B().core);
    for (int k = 0; k < 40; ++k) {
      const auto any = [&](const std::vector<FeatureId>& all) {
        return all[static_cast<std::size_t>(dice.between(0, static_cast<int>(all.size()) - 1))];
      };
      const FeatureId a = any(of_A);
      const Proximity found = pair.from({a, any(of_B)});
      REQUIRE(found.verdict == truth.verdict);
      REQUIRE(found.enclosure.lo <= truth.distance.lo);
      REQUIRE(found.enclosure.hi >= truth.distance.hi);
    }
  }
}

TEST_CASE("warm or cold, the answer is compatible") {
  Dice dice(7);
  for (int i = 0; i < 20; ++i) {
    Scene scene = small_round_pair(dice, 4);
    FeaturePair memory;
    for (int frame = 0; frame < 50; ++frame) {
      scene.bodies[1].X_WB.p_WB += 0.05 * dice.in_cube();
      const Pair pair(scene);
      const Proximity cold = pair.from({});
      const Proximity warm = proximity(pair.A(), pair.cached_A, pair.B(), pair.cached_B, memory);
      REQUIRE(warm.verdict == cold.verdict);
      REQUIRE(warm.enclosure.lo <= cold.enclosure.hi);
      REQUIRE(cold.enclosure.lo <= warm.enclosure.hi);
    }
  }
}

// --------------------------------------------------------------------------------------------------- coverage marks

/// Unit cubes: vertex i by the bits of i, as model/shape.h says.
Scene cubes(const Vec3& apart, const Quaternion& q = {}) {
  return tests::pair_of({{Box{Vec3(1, 1, 1)}}, {Box{Vec3(1, 1, 1)}, apart, q}});
}

int edge_between(const Hull& hull, int v, int w) {
  for (int e = 0; e < hull.edge_count(); ++e) {
    if (hull.edge(e).tail == std::min(v, w) && hull.edge(e).head == std::max(v, w)) return e;
  }
  return -1;
}

int face_towards(const Hull& hull, const Vec3& n) {
  for (int f = 0; f < hull.face_count(); ++f) {
    if (hull.face(f).normal.dot(n) > 0.9) return f;
  }
  return -1;
}

std::string kinds(const FeaturePair& pair) {
  const char* const letters = "VEF";
  return {letters[static_cast<int>(pair.a.kind)], letters[static_cast<int>(pair.b.kind)]};
}

std::string trail(const Scene& scene, const FeaturePair& seed) {
  const Pair pair(scene);
  std::vector<Closest> visited;
  const Walked walked = walk(pair.placed_A(), pair.placed_B(), seed, &visited);
  std::string said;
  for (const Closest& c : visited) {
    if (!said.empty()) said.push_back(' ');
    said.append(kinds(c.features));
  }
  if (walked.inside) said.append(" inside");
  return said;
}

/// A cube and a point (a ball's core).
Scene cube_and_point(const Vec3& p) { return tests::pair_of({{Box{Vec3(1, 1, 1)}}, {Sphere{0.125}, p}}); }

TEST_CASE("marks: where walks end") {
  const FeatureId v7{Kind::vertex, 7};
  const FeatureId v0{Kind::vertex, 0};
  const auto end = [&](const Scene& scene) { return kinds(Pair(scene).from({v0, v0}).features); };
  const auto end_swapped = [&](const Scene& scene) { return end(tests::pair(scene.bodies[1], scene.bodies[0])); };
  // Corner to corner along the diagonal.
  CHECK(trail(cubes(Vec3(3, 3, 3)), {v7, v0}) == "VV");
  // A point off a corner, an edge, a face.
  CHECK(end(cube_and_point(Vec3(3, 2, 4))) == "VV");
  CHECK(end(cube_and_point(Vec3(3, 0.2, 4))) == "EV");
  CHECK(end(cube_and_point(Vec3(0.1, 0.2, 4))) == "FV");
  CHECK(end_swapped(cube_and_point(Vec3(3, 0.2, 4))) == "VE");
  CHECK(end_swapped(cube_and_point(Vec3(0.1, 0.2, 4))) == "VF");
  // Crossed edges.
  const Scene crossed = tests::pair_of({{Box{Vec3(1, 1, 1)}, Vec3::Zero(), {1, 0, 0.4142135623730951, 0}},
                                        {Box{Vec3(1, 1, 1)}, Vec3(0, 0, 3.2), {1, 0.4142135623730951, 0, 0}}});
  CHECK(kinds(Pair(crossed).from({v7, v0}).features) == "EE");
}

TEST_CASE("marks: ways from kind to kind") {
  const Hull cube(Box{Vec3(1, 1, 1)});
  const FeatureId v0{Kind::vertex, 0};
  const FeatureId top{Kind::face, face_towards(cube, Vec3::UnitZ())};
  const FeatureId bottom{Kind::face, face_towards(cube, -Vec3::UnitZ())};
  std::set<std::string> steps;
  const auto note = [&](const Scene& scene, const FeaturePair& seed) {
    const std::string said = trail(scene, seed);
    for (std::size_t i = 0; i + 5 <= said.size() && said[i + 2] == ' ' && said[i + 3] != 'i'; i += 3) {
      steps.insert(said.substr(i, 5));
    }
  };
  Dice dice(8);
  for (int i = 0; i < 400; ++i) {
    const Scene scene = small_round_pair(dice, 3);
    note(scene, {{Kind::vertex, 0}, {Kind::face, 0}});
    note(scene, {{Kind::vertex, 0}, {Kind::vertex, 0}});
    note(scene, {{Kind::edge, 0}, {Kind::edge, 0}});
  }
  for (const char* const step : {"VV VV", "VV EV", "VV VE", "VE EE", "EV EE", "VE VF", "EV FV", "EE FV", "EE VF",
                                 "VF VF", "VF EE", "FV EE", "VE VV", "EV VV", "EE VE", "EE EV"}) {
    INFO(step);
    CHECK(steps.count(step) == 1);
  }
  // From a face on the far side, the other body is below it: the face that sees it best takes over.
  CHECK(trail(cube_and_point(Vec3(0.1, 0.2, 4)), {bottom, v0}) == "FV");
  // Starts at two faces, and at an edge and a face.
  CHECK(trail(cubes(Vec3(0.1, 0.2, 4)), {top, bottom}).substr(0, 2) != "FF");
  CHECK(trail(cubes(Vec3(0.1, 0.2, 4)), {{Kind::edge, 0}, bottom}).substr(0, 2) != "EF");
}

TEST_CASE("facing features: walks of large hulls take less than half of the steps from there, and soon begin there") {
  Dice dice(29);
  std::size_t from_first = 0, from_facing = 0;
  constexpr int walks = 40;
  for (int i = 0; i < walks; ++i) {
    const Vec3 apart = 2.5 * dice.in_cube().normalized();
    const Quaternion q = tests::integer_quaternion(dice);
    const Scene scene = tests::pair_of({{tests::round_hull(dice, 300), apart, q}, {tests::round_hull(dice, 300)}});
    const Pair pair(scene);
    const PosedHull A = pair.placed_A(), B = pair.placed_B();
    std::vector<Closest> visited;
    walk(A, B, {}, &visited);
    from_first += visited.size();
    visited.clear();
    walk(A, B, facing_features(A, B), &visited);
    from_facing += visited.size();
  }
  CHECK(2 * from_facing < from_first);
  CHECK(from_first <= from_facing + 6 * walks);  // the start and five steps before them
  // Origins that coincide define no direction: any vertices will do.
  const Pair concentric(cubes(Vec3::Zero()));
  const FeaturePair start = facing_features(concentric.placed_A(), concentric.placed_B());
  CHECK(start.a.kind == Kind::vertex);
  CHECK(start.b.kind == Kind::vertex);
}

TEST_CASE("marks: degenerate exits") {
  const FeatureId v0{Kind::vertex, 0};
  const Hull cube(Box{Vec3(1, 1, 1)});
  const FeatureId top{Kind::face, face_towards(cube, Vec3::UnitZ())};
  // A vertex inside: found by the walk, proved by the exact route.
  CHECK(trail(cubes(Vec3(0.5, 0.5, 0.5)), {top, v0}) == " inside");
  CHECK(Pair(cubes(Vec3(0.5, 0.5, 0.5))).from({top, v0}).verdict == Verdict::overlapping);
  // An edge through a face, no vertex inside.
  const Scene cross = tests::pair_of({{Box{Vec3(3, 1, 1)}}, {Box{Vec3(1, 3, 1)}, Vec3(0, 0, 0.5)}});
  CHECK(Pair(cross).from({{Kind::edge, edge_between(cube, 0, 1)}, top}).verdict == Verdict::overlapping);
  // Parallel edges, parallel faces: the result is among the closest pairs, and doubles decide.
  for (const Vec3& apart : {Vec3(0.5, 3, 3), Vec3(0.5, 0.5, 3), Vec3(2, 2, 3), Vec3(2, 5, 5)}) {
    const Proximity found = Pair(cubes(apart)).from({v0, v0});
    CHECK(found.verdict == Verdict::separated);
    CHECK(found.closest_vertices_A.empty());
  }
  // Exact contact of each kind: decided exactly.
  for (const Vec3& apart : {Vec3(2, 2, 2), Vec3(2, 2, 0.5), Vec3(2, 0.5, 0.5), Vec3(2, 2, 0), Vec3(2, 0, 0)}) {
    const Proximity found = Pair(cubes(apart)).from({v0, v0});
    CHECK(found.verdict == Verdict::touching);
    CHECK_FALSE(found.closest_vertices_A.empty());
    CHECK(found.enclosure == Interval{0, 0});
  }
  // One ulp apart, one ulp of overlap.
  CHECK(Pair(cubes(Vec3(2 + 0x1p-51, 0.5, 0.5))).from({v0, v0}).verdict == Verdict::separated);
  CHECK(Pair(cubes(Vec3(2 - 0x1p-52, 0.5, 0.5))).from({v0, v0}).verdict == Verdict::overlapping);
  // Lengths that doubles cannot multiply.
  Scene tiny = cubes(Vec3(3, 0.5, 0.5));
  tests::scale(tiny, -400);
  const Proximity found = Pair(tiny).from({v0, v0});
  CHECK(found.enclosure.lo <= 0x1p-400);
  CHECK(found.enclosure.hi >= 0x1p-400);
  CHECK_FALSE(found.closest_vertices_A.empty());
}

}  // namespace
}  // namespace touchstone::fast::lin_canny
