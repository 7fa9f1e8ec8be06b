#include "reference/distance.h"

#include <cmath>
#include <limits>
#include <utility>

#include "reference/agreement.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::body;
using tests::Dice;
using tests::pair;

const double ulp = std::numeric_limits<double>::epsilon();

using Vertices = std::vector<int>;

RationalVec3 vec(const Rational& x, const Rational& y, const Rational& z) { return {x, y, z}; }

Scene swapped(const Scene& scene) { return pair(scene.bodies[1], scene.bodies[0]); }

/// A pyramid with its apex, vertex 0, at the origin, opening upwards.
Polytope needle() { return convex_hull({Vec3(0, 0, 0), Vec3(1, 0, 4), Vec3(-1, 1, 4), Vec3(-1, -1, 4)}); }

/// A wedge with its ridge, vertices 0 and 1, along x at z = 0, above it.
Polytope roof() { return convex_hull({Vec3(-2, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 3), Vec3(0, -1, 3)}); }

/// Its ridge, vertices 0 and 1, along y at z = 0, below it.
Polytope keel() { return convex_hull({Vec3(0, -2, 0), Vec3(0, 2, 0), Vec3(1, 0, -3), Vec3(-1, 0, -3)}); }

/// All three routes agree, and this is what they say.
DistanceTruth agreed(const Scene& scene) {
  CHECK(disagreement(scene) == "");
  return distance(scene);
}

TEST_CASE("distance: vertex to vertex") {
  const DistanceTruth t = agreed(pair(body(needle(), Vec3(3, 4, 13)), body(Box{Vec3(1, 1, 1)}, Vec3(-1, -1, 0))));
  CHECK(t.verdict == Verdict::separated);
  CHECK(t.core_squared == Rational(9 + 16 + 144));
  CHECK(t.difference == vec(3, 4, 12));
  CHECK(t.distance == Interval{13, 13});
  CHECK(t.feature_A == Feature{0, {0}});
  CHECK(t.feature_B == Feature{0, {7}});
  CHECK(t.p_WCa == Vec3(3, 4, 13));
  CHECK(t.p_WCb == Vec3(0, 0, 1));
}

TEST_CASE("distance: vertex to edge") {
  const DistanceTruth t = agreed(pair(body(needle(), Vec3(0.5, 5, 5)), body(Box{Vec3(1, 1, 1)})));
  CHECK(t.core_squared == Rational(32));
  CHECK(t.difference == vec(0, 4, 4));
  CHECK(t.feature_A == Feature{0, {0}});
  CHECK(t.feature_B == Feature{0, {6, 7}});
  CHECK(t.p_WCb == Vec3(0.5, 1, 1));
  CHECK(t.distance.lo < t.distance.hi);
  CHECK(Rational(t.distance.lo) * Rational(t.distance.lo) < Rational(32));
  CHECK(Rational(t.distance.hi) * Rational(t.distance.hi) > Rational(32));
  CHECK(std::nextafter(t.distance.lo, 100) == t.distance.hi);
}

TEST_CASE("distance: vertex to face") {
  const DistanceTruth t = agreed(pair(body(needle(), Vec3(0.25, 0.5, 3)), body(Box{Vec3(1, 1, 1)})));
  CHECK(t.difference == vec(0, 0, 2));
  CHECK(t.feature_A == Feature{0, {0}});
  CHECK(t.feature_B == Feature{0, {4, 5, 6, 7}});
  CHECK(t.p_WCa == Vec3(0.25, 0.5, 3));
  CHECK(t.p_WCb == Vec3(0.25, 0.5, 1));
}

TEST_CASE("distance: edge to edge") {
  const DistanceTruth t = agreed(pair(body(roof(), Vec3(1, 1, 0.75)), body(keel())));
  CHECK(t.difference == vec(0, 0, 0.75));
  CHECK(t.feature_A == Feature{0, {0, 1}});
  CHECK(t.feature_B == Feature{0, {0, 1}});
  CHECK(t.p_WCa == Vec3(0, 1, 0.75));
  CHECK(t.p_WCb == Vec3(0, 1, 0));
}

TEST_CASE("distance: parallel edges: the features are all of both") {
  const DistanceTruth t = agreed(pair(body(roof(), Vec3(1, 0, 2)), body(Box{Vec3(3, 1, 1)}, Vec3(0, -1, 0))));
  CHECK(t.difference == vec(0, 0, 1));
  CHECK(t.feature_A == Feature{0, {0, 1}});
  CHECK(t.feature_B == Feature{0, {4, 5, 6, 7}});
}

TEST_CASE("distance: face to face: all ties are told") {
  const DistanceTruth t = agreed(pair(body(Box{Vec3(1, 1, 1)}, Vec3(2.5, 0.5, 0)), body(Box{Vec3(1, 2, 3)})));
  CHECK(t.difference == vec(0.5, 0, 0));
  CHECK(t.feature_A == Feature{0, {0, 2, 4, 6}});
  CHECK(t.feature_B == Feature{0, {1, 3, 5, 7}});
}

TEST_CASE("distance: a rotated pair with a rational distance") {
  // B is a cube turned by cos = 3/5, sin = 4/5 about z: it reaches 1·3/5 + 1·4/5 = 7/5 along x.
  const DistanceTruth t =
      agreed(pair(body(Box{Vec3(1, 5, 5)}, Vec3(4, 0, 0)), body(Box{Vec3(1, 1, 1)}, Vec3::Zero(), {2, 0, 0, 1})));
  CHECK(t.difference == vec(Rational("8/5"), 0.0, 0.0));
  CHECK(t.core_squared == Rational("64/25"));
  CHECK(t.distance == Rational("8/5").enclosure());
}

TEST_CASE("distance: spheres") {
  SECTION("apart: the distance is between the surfaces") {
    const DistanceTruth t = agreed(pair(body(Sphere{1}, Vec3(3, 4, 0)), body(Sphere{2})));
    CHECK(t.verdict == Verdict::separated);
    CHECK(t.distance == Interval{2, 2});
    CHECK(t.core_squared == Rational(25));
    CHECK((t.p_WCa - Vec3(2.4, 3.2, 0)).norm() <= 4 * ulp);
    CHECK((t.p_WCb - Vec3(1.2, 1.6, 0)).norm() <= 4 * ulp);
    CHECK(t.feature_A == Feature{0, {0}});
  }
  SECTION("touching") {
    CHECK(agreed(pair(body(Sphere{3}, Vec3(3, 4, 0)), body(Sphere{2}))).verdict == Verdict::touching);
  }
  SECTION("an ulp deeper") {
    CHECK(agreed(pair(body(Sphere{3 + 2 * ulp}, Vec3(3, 4, 0)), body(Sphere{2}))).verdict == Verdict::overlapping);
  }
  SECTION("an ulp apart: the tightest doubles around 2 ulps") {
    const DistanceTruth t = agreed(pair(body(Sphere{3 - 2 * ulp}, Vec3(3, 4, 0)), body(Sphere{2})));
    CHECK(t.verdict == Verdict::separated);
    CHECK(t.distance == Interval{2 * ulp, 2 * ulp});
  }
  SECTION("an irrational gap far below the radii stays tight") {
    // √2 − r for the double r just below √2: about 1e-16, known to 53 bits.
    const double r = 1.4142135623730949;
    const DistanceTruth t = agreed(pair(body(Sphere{r / 2}, Vec3(1, 1, 0)), body(Sphere{r / 2})));
    CHECK(t.verdict == Verdict::separated);
    CHECK(std::nextafter(t.distance.lo, 1) == t.distance.hi);
    const auto squared = [&](double gap) { return (Rational(gap) + Rational(r)) * (Rational(gap) + Rational(r)); };
    CHECK(squared(t.distance.lo) < Rational(2));
    CHECK(squared(t.distance.hi) > Rational(2));
  }
  SECTION("concentric") { CHECK(agreed(pair(body(Sphere{1}), body(Sphere{2}))).verdict == Verdict::overlapping); }
  SECTION("a centre inside, on, above a box") {
    const auto verdict = [&](double z, double r) {
      return agreed(pair(body(Sphere{r}, Vec3(0.5, 0, z)), body(Box{Vec3(1, 1, 1)}))).verdict;
    };
    CHECK(verdict(0, 0.125) == Verdict::overlapping);
    CHECK(verdict(1, 0.125) == Verdict::overlapping);
    CHECK(verdict(1.125, 0.125) == Verdict::touching);
    CHECK(verdict(1.125 + ulp, 0.125) == Verdict::separated);
    CHECK(verdict(1.125 - ulp, 0.125) == Verdict::overlapping);
  }
}

TEST_CASE("distance: touching of every kind of feature, and an ulp to either side of it") {
  struct Touch {
    std::string name;
    Scene scene;
    Vertices on_A;
    Vertices on_B;
    Vec3 up;  ///< moves A off B
  };
  const Box cube{Vec3(1, 1, 1)};
  const std::vector<Touch> touches = {
      {"vertex, vertex", pair(body(needle(), Vec3(1, 1, 1)), body(cube)), {0}, {7}, Vec3(0, 0, 1)},
      {"vertex, edge", pair(body(needle(), Vec3(0.5, 1, 1)), body(cube)), {0}, {6, 7}, Vec3(0, 0, 1)},
      {"vertex, face", pair(body(needle(), Vec3(0.5, 0, 1)), body(cube)), {0}, {4, 5, 6, 7}, Vec3(0, 0, 1)},
      {"edge, edge, crossed", pair(body(roof()), body(keel())), {0, 1}, {0, 1}, Vec3(0, 0, 1)},
      {"edge, edge, along", pair(body(roof(), Vec3(2, 1, 1)), body(cube)), {0, 1}, {6, 7}, Vec3(0, 0, 1)},
      {"edge, face", pair(body(roof(), Vec3(2, 0.5, 1)), body(cube)), {0, 1}, {4, 5, 6, 7}, Vec3(0, 0, 1)},
      {"face, face", pair(body(cube, Vec3(0.5, 1.5, 2)), body(cube)), {0, 1, 2, 3}, {4, 5, 6, 7}, Vec3(0, 0, 1)},
      {"faces that share an edge", pair(body(cube, Vec3(2, 0, 2)), body(cube)), {0, 2}, {5, 7}, Vec3(0, 0, 1)},
      {"faces that share a vertex", pair(body(cube, Vec3(2, 2, 2)), body(cube)), {0}, {7}, Vec3(0, 0, 1)},
  };
  for (const Touch& touch : touches) {
    DYNAMIC_SECTION(touch.name) {
      const DistanceTruth t = agreed(touch.scene);
      CHECK(t.verdict == Verdict::touching);
      CHECK(t.core_squared.sign() == 0);
      CHECK(t.distance == Interval{0, 0});
      CHECK(t.feature_A.vertices == touch.on_A);
      CHECK(t.feature_B.vertices == touch.on_B);
      CHECK(t.p_WCa == t.p_WCb);
      for (const double step : {4 * ulp, 0x1p-30, 0x1p-10}) {
        Scene apart = touch.scene;
        apart.bodies[0].X_WB.p_WB += step * touch.up;
        CHECK(agreed(apart).verdict == Verdict::separated);
        CHECK(distance(apart).distance == Interval{step, step});
      }
    }
  }
}

TEST_CASE("distance: a face pressed in by an ulp overlaps") {
  for (const double depth : {2 * ulp, 0x1p-40, 0x1p-20, 0.5}) {
    CHECK(agreed(pair(body(Box{Vec3(1, 1, 1)}, Vec3(0.5, 1.5, 2 - depth)), body(Box{Vec3(1, 1, 1)}))).verdict ==
          Verdict::overlapping);
    CHECK(agreed(pair(body(needle(), Vec3(0.5, 0, 1 - depth)), body(Box{Vec3(1, 1, 1)}))).verdict ==
          Verdict::overlapping);
    CHECK(agreed(pair(body(roof(), Vec3(0, 0, -depth)), body(keel()))).verdict == Verdict::overlapping);
  }
}

TEST_CASE("distance: a proof of overlap exists where no tetrahedron of differences is around 0") {
  const Polytope octahedron =
      convex_hull({Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)});
  const Scene scene = pair(body(Sphere{0.125}), body(octahedron));
  CHECK(agreed(scene).verdict == Verdict::overlapping);
  CHECK(distance(scene).certificate.cores == Verdict::overlapping);
}

TEST_CASE("distance: compounds: the nearest parts speak, any overlap is an overlap") {
  Compound two;
  two.parts.push_back({{Vec3(5, 0, 0), {}}, Box{Vec3(1, 1, 1)}});
  two.parts.push_back({{Vec3(0, 5, 0), {1, 0, 0, 1}}, Sphere{1}});
  const DistanceTruth apart = agreed(pair(body(two, Vec3(0, 0, 1)), body(Box{Vec3(1, 1, 1)}, Vec3(0, 1, 1))));
  CHECK(apart.verdict == Verdict::separated);
  CHECK(apart.part_A == 1);
  CHECK(apart.feature_A == Feature{1, {0}});
  CHECK(apart.distance == Interval{2, 2});

  CHECK(agreed(pair(body(two), body(Box{Vec3(4, 1, 1)}))).verdict == Verdict::touching);
  CHECK(agreed(pair(body(two), body(Box{Vec3(4, 4.5, 1)}))).verdict == Verdict::overlapping);
  CHECK(agreed(pair(body(two), body(Box{Vec3(4, 4.5, 1)}))).part_A == 1);
}

TEST_CASE("distance: parts compare by the distance of their surfaces, exactly") {
  // Centres 2 and √2 apart with radii that make the gaps differ by less than an ulp of either.
  Compound two;
  two.parts.push_back({{Vec3(2, 0, 0), {}}, Sphere{1.5857864376269049}});
  two.parts.push_back({{Vec3(1, 1, 0), {}}, Sphere{1}});
  const DistanceTruth t = agreed(pair(body(two), body(Sphere{0.125})));
  const Rational r = Rational(1.5857864376269049) - Rational(1);  // 2 − √2 = 0.58578643762690495…
  const bool first_nearer = (Rational(2) - r) * (Rational(2) - r) < Rational(2);
  CHECK(t.part_A == (first_nearer ? 0 : 1));
}

TEST_CASE("distance: swapping the bodies turns d* around and changes nothing else") {
  Dice dice(3);
  for (int i = 0; i < 20 * tests::hard_families; ++i) {
    const Scene scene = tests::hard_pair(i % tests::hard_families, dice);
    const DistanceTruth ab = distance(scene);
    const DistanceTruth ba = distance(swapped(scene));
    CAPTURE(i);
    REQUIRE(ab.verdict == ba.verdict);
    REQUIRE(ab.core_squared == ba.core_squared);
    REQUIRE(ab.distance == ba.distance);
    if (ab.core_squared.sign() != 0 || ab.verdict == Verdict::touching) {
      REQUIRE(ab.feature_A.vertices == ba.feature_B.vertices);
      REQUIRE(ab.feature_B.vertices == ba.feature_A.vertices);
      REQUIRE(ab.difference == vec(-ba.difference.x, -ba.difference.y, -ba.difference.z));
    }
  }
}

TEST_CASE("distance: the three routes agree and prove it, on 2,000 small lattice pairs of every verdict") {
  Dice dice(1);
  int seen[3] = {0, 0, 0};
  for (int i = 0; i < 2000; ++i) {
    const Scene scene = tests::hard_pair(i % 3, dice);
    CAPTURE(i);
    REQUIRE(disagreement(scene) == "");
    ++seen[static_cast<int>(distance(scene).verdict)];
  }
  CHECK(seen[0] > 100);
  CHECK(seen[1] > 20);
  CHECK(seen[2] > 100);
}

TEST_CASE("distance: the three routes agree on every near-degenerate family") {
  Dice dice(2);
  for (int family = 3; family < tests::hard_families; ++family) {
    for (int i = 0; i < 25; ++i) {
      CAPTURE(family, i);
      REQUIRE(disagreement(tests::hard_pair(family, dice)) == "");
    }
  }
}

TEST_CASE("distance: a tied pair on which the pricing of CGAL's Polytope_distance_d cycles for ever") {
  const Polytope A =
      convex_hull({Vec3(0, -2, 2), Vec3(2, 0, -2), Vec3(1, 0, -2), Vec3(-1, -2, -1), Vec3(-1, 1, 1), Vec3(1, 2, 0)});
  const Polytope B = convex_hull({Vec3(1, 0, 1), Vec3(3, 3, -2), Vec3(-3, 1, -3), Vec3(-1, 0, 3), Vec3(-3, -2, -2),
                                  Vec3(2, 2, 1), Vec3(-3, 1, 2), Vec3(-3, -2, 3), Vec3(2, -3, -2)});
  agreed(pair(body(A, Vec3(-1, -1, -1), {-1, -3, 3, -3}), body(B, Vec3(-2, 2, 4), {0, -2, -3, 1})));
}

// The gaps are √(n² + 1) − r − s and n − t − s. As √(n² + 1) = n + 1/(2n) − 1/(8n³) + 1/(16n⁵) − ..., partial sums of
// the series are in turn too great and too small. No certificate shows which of two parts is nearer.
TEST_CASE("distance: of two balls of a compound whose gaps nearly tie, the nearer one is found") {
  for (const double n : {0x1p3, 0x1p10, 0x1p20, 0x1p25}) {
    const double above = 0.5 / n, below = above - 0.125 / n / n / n, t = 0.5 / n;
    const auto nearer = [&](double r, bool exchanged) {
      Compound both{{{Pose{Vec3(n, 1, 0), {}}, Sphere{r}}, {Pose{Vec3(0, 0, n), {}}, Sphere{t}}}};
      if (exchanged) std::swap(both.parts[0], both.parts[1]);
      return agreed(pair(body(both), body(Sphere{0.25})));
    };
    CAPTURE(n);
    REQUIRE(Rational(t) + Rational(below) == Rational(t + below));
    CHECK(nearer(t + above, false).part_A == 0);
    CHECK(nearer(t + above, true).part_A == 1);
    CHECK(nearer(t + below, false).part_A == 1);
    CHECK(nearer(t + below, true).part_A == 0);
    CHECK(nearer(t + above, false).distance.lo <= n - t - 0.25);
    CHECK(nearer(t + below, false).distance == (Rational(n) - Rational(t) - Rational(0.25)).enclosure());
  }
}

TEST_CASE("distance: of balls the enclosure is two neighbours, whatever cancels") {
  for (const double r : {1.0, 0x1p20, 0x1p26}) {
    for (const double off : {0x1p-26, 0x1p-10, 1.0}) {
      CAPTURE(r, off);
      const Interval gap = distance(pair(body(Sphere{r}, Vec3(r, off, 0)), body(Sphere{0x1p-60}))).distance;
      const Rational x = Rational(r) * Rational(r) + Rational(off) * Rational(off), R = Rational(r) + Rational(0x1p-60);
      const Rational lo = Rational(gap.lo) + R, hi = Rational(gap.hi) + R;
      if (gap == Interval{0, 0}) {
        CHECK(x <= R * R);
        continue;
      }
      CHECK(lo * lo <= x);
      CHECK(hi * hi >= x);
      CHECK((gap.lo == gap.hi || std::nextafter(gap.lo, 1.0) == gap.hi));
    }
  }
}

TEST_CASE("distance: a point's distance to a body") {
  const Body box = body(Box{Vec3(1, 1, 1)}, Vec3(1, 0, 0), {1, 0, 0, 1});
  CHECK(distance_to_body(box, Vec3(1, 0, 0)) == Interval{0, 0});
  CHECK(distance_to_body(box, Vec3(2, 1, 1)) == Interval{0, 0});
  CHECK(distance_to_body(box, Vec3(5, 1, 5)) == Interval{5, 5});
  CHECK(distance_to_body(box, Vec3(2 + 2 * ulp, 0, 0)) == Interval{2 * ulp, 2 * ulp});
  const Body ball = body(Sphere{2}, Vec3(0, 0, 1));
  CHECK(distance_to_body(ball, Vec3(0, 0, 2)) == Interval{0, 0});
  CHECK(distance_to_body(ball, Vec3(3, 4, 1)) == Interval{3, 3});
  Compound both;
  both.parts = {{{Vec3(10, 0, 0), {}}, Sphere{1}}, {{Vec3(0, 0, 0), {}}, Box{Vec3(1, 1, 1)}}};
  CHECK(distance_to_body(body(both), Vec3(7, 0, 0)) == Interval{2, 2});
}

}  // namespace
}  // namespace touchstone::reference
