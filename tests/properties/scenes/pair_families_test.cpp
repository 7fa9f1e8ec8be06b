// The families of pairs reach what they are for: counted from the reference's answers and from the drawn numbers.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "oracle/truth/truth.h"
#include "tests/catch.h"
#include "tests/properties/scenes/drawn.h"

using namespace touchstone;
using tests::count;
using tests::drawn;

namespace {

constexpr int draws = 60;

int count(const std::vector<Scene>& scenes, Verdict verdict) {
  return tests::count(scenes, [&](const Scene& s) { return oracle::truth::distance(s).verdict == verdict; });
}

/// The vertices that are no corners of the hull.
std::size_t redundant(const Polytope& solid) {
  return solid.vertices.size() - oracle::truth::convex_hull(solid.vertices).vertices.size();
}

/// The vertices that no face names.
std::size_t unnamed(const Polytope& solid) {
  std::set<int> named;
  for (const std::vector<int>& face : solid.faces) named.insert(face.begin(), face.end());
  return solid.vertices.size() - named.size();
}

bool sum_rounds(double a, double b) {
  const double sum = a + b, from_b = sum - a;
  return (a - (sum - from_b)) + (b - from_b) != 0;
}

double radius(const Body& body) { return std::get<Sphere>(body.shape).radius; }

const std::vector<Part>& parts(const Body& body) { return std::get<Compound>(body.shape).parts; }

}  // namespace

TEST_CASE("drawn pairs: hulls.redundant has vertices that are no corners, named by faces and not, in any order") {
  const std::vector<Scene> scenes = drawn("hulls.redundant", draws);
  const auto sum = [](const Scene& s, auto&& of) {
    return of(std::get<Polytope>(s.bodies[0].shape)) + of(std::get<Polytope>(s.bodies[1].shape));
  };
  for (const Scene& scene : scenes) CHECK(sum(scene, redundant) >= 1);
  CHECK(count(scenes, [&](const Scene& s) { return sum(s, redundant) > sum(s, unnamed); }) >= 30);
  CHECK(count(scenes, [&](const Scene& s) { return sum(s, unnamed) >= 2; }) >= 30);
  CHECK(count(scenes, Verdict::touching) >= 6);
}

TEST_CASE("drawn pairs: those whose gap is relative to their size are apart as often as they overlap") {
  const std::vector<Scene> scenes = drawn("touching.relative_gap", draws);
  CHECK(count(scenes, Verdict::separated) >= 15);
  CHECK(count(scenes, Verdict::overlapping) >= 15);
}

TEST_CASE("drawn pairs: spheres.odd_sums touches exactly where the sum of the radii is not a double") {
  const std::vector<Scene> scenes = drawn("spheres.odd_sums", draws);
  CHECK(count(scenes, Verdict::touching) >= 15);
  for (const Scene& scene : scenes) {
    const bool touches = oracle::truth::distance(scene).verdict == Verdict::touching;
    CHECK((!touches || sum_rounds(radius(scene.bodies[0]), radius(scene.bodies[1]))));
  }
  CHECK(count(scenes, Verdict::separated) >= 8);
  CHECK(count(scenes, Verdict::overlapping) >= 8);
}

TEST_CASE("drawn pairs: compounds.unlike has parts of several kinds that touch") {
  const std::vector<Scene> scenes = drawn("compounds.unlike", draws);
  const auto kinds = [](const Body& body) {
    std::set<std::size_t> found;
    for (const Part& part : parts(body)) found.insert(part.shape.index());
    return found.size();
  };
  CHECK(count(scenes, [&](const Scene& s) { return kinds(s.bodies[0]) >= 2 && kinds(s.bodies[1]) >= 2; }) >= 20);
  CHECK(count(scenes, Verdict::touching) >= 8);
}

TEST_CASE("drawn pairs: compounds.balls differ in size by 2^10 and more, and touch") {
  const std::vector<Scene> scenes = drawn("compounds.balls", draws);
  const auto is_unlike = [](const Scene& scene) {
    double least = 1e300, most = 0;
    for (const Body& body : scene.bodies) {
      for (const Part& part : parts(body)) {
        least = std::min(least, std::get<Sphere>(part.shape).radius);
        most = std::max(most, std::get<Sphere>(part.shape).radius);
      }
    }
    return most >= 0x1p10 * least;
  };
  CHECK(count(scenes, is_unlike) >= 30);
  CHECK(count(scenes, Verdict::touching) >= 8);
}

TEST_CASE("drawn pairs: compounds.far are 2^40 from the origin, from each other, or have a part that far away") {
  const std::vector<Scene> scenes = drawn("compounds.far", draws);
  const auto is_far = [](const Body& body) { return body.X_WB.p_WB.norm() >= 0x1p40; };
  const auto has_far_part = [](const Body& body) {
    return std::ranges::any_of(parts(body), [](const Part& part) { return part.X_BP.p_WB.norm() >= 0x1p40; });
  };
  int from_origin = 0, from_each_other = 0, with_far_part = 0;
  for (const Scene& scene : scenes) {
    const int far = is_far(scene.bodies[0]) + is_far(scene.bodies[1]);
    const bool far_part = has_far_part(scene.bodies[0]) || has_far_part(scene.bodies[1]);
    CHECK((far > 0 || far_part));
    from_origin += far == 2;
    from_each_other += far == 1;
    with_far_part += far_part;
  }
  CHECK(from_origin >= 10);
  CHECK(from_each_other >= 10);
  CHECK(with_far_part >= 10);
  CHECK(count(scenes, Verdict::touching) >= 5);
}

TEST_CASE("families: boxes of films.falling_over turn about their lowest corners") {
  int moves = 0, stay = 0, turn = 0;
  for (const Scene& sequence : drawn("films.falling_over", 20)) {
    const auto& frames = oracle::truth::sequence_bounds(sequence);
    for (std::size_t f = 1; f < frames.size(); ++f) {
      for (std::size_t i = 0; i < sequence.bodies.size(); ++i) {
        if (!frames[f - 1][i] || !frames[f][i]) continue;
        const auto same = [&](const auto& before, const auto& now) {
          return std::ranges::equal(before, now,
                                    [](const auto& a, const auto& b) { return a.nearest() == b.nearest(); });
        };
        const bool same_hi = same(frames[f - 1][i]->hi, frames[f][i]->hi);
        if (same_hi && same(frames[f - 1][i]->lo, frames[f][i]->lo)) continue;
        ++moves;
        stay += same(frames[f - 1][i]->lo, frames[f][i]->lo) ? 1 : 0;
        turn += same_hi ? 0 : 1;
      }
    }
  }
  CHECK(moves > 0);
  CHECK(5 * stay > 4 * moves);  // others are taken out and put elsewhere
  CHECK(turn > 0);
}
