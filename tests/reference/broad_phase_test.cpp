#include "reference/broad_phase.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::Dice;

Scene cubes(const std::vector<Vec3>& centres) {
  Scene scene;
  for (const Vec3& p : centres) scene.bodies.push_back(tests::body(Box{Vec3(1, 1, 1)}, p));
  return scene;
}

TEST_CASE("broad_phase: closed boxes that share a face, an edge or a corner overlap, an ulp apart they do not") {
  for (const Vec3& p : {Vec3(2, 0, 0), Vec3(2, 2, 0), Vec3(-2, 2, 2)})
    CHECK(broad_phase(cubes({Vec3::Zero(), p})).size() == 1);
  CHECK(broad_phase(cubes({Vec3::Zero(), Vec3(0, std::nextafter(2, 3), 0)})).empty());
  CHECK(broad_phase(cubes({Vec3::Zero(), Vec3(0, 0, -std::nextafter(2, 3))})).empty());
  CHECK(broad_phase(cubes({Vec3::Zero(), Vec3(0, std::nextafter(2, 1), 0)})).size() == 1);
}

TEST_CASE("broad_phase: no pair without two bodies") {
  CHECK(broad_phase(Scene{}).empty());
  CHECK(broad_phase(cubes({Vec3::Zero()})).empty());
}

// Cubes of half extent 1 on a lattice overlap exactly when no coordinate differs by more than 2.
TEST_CASE("broad_phase: all pairs, each once, sorted") {
  Dice dice(51);
  for (int i = 0; i < 100; ++i) {
    std::vector<Vec3> centres;
    for (int k = 0; k < 12; ++k) centres.push_back(dice.lattice(5));
    PairSet expected;
    for (int a = 0; a < 12; ++a) {
      for (int b = a + 1; b < 12; ++b) {
        const Vec3 apart = centres[static_cast<std::size_t>(a)] - centres[static_cast<std::size_t>(b)];
        if (apart.cwiseAbs().maxCoeff() <= 2) expected.emplace_back(a, b);
      }
    }
    REQUIRE(broad_phase(cubes(centres)) == expected);
    for (Vec3& c : centres) c += Vec3(0x1p52, -0x1p52, 0x1p51);
    REQUIRE(broad_phase(cubes(centres)) == expected);
  }
}

TEST_CASE("broad_phase: the gap's sign is the verdict, its value the widest of the axes'") {
  const auto gap_of = [](const Scene& scene) {
    const auto boxes = bounds(scene);
    const Rational there = gap(boxes[0], boxes[1]);
    REQUIRE(there == gap(boxes[1], boxes[0]));
    REQUIRE((there.sign() <= 0) == (broad_phase(scene).size() == 1));
    return there;
  };
  CHECK(gap_of(cubes({Vec3::Zero(), Vec3(5, -7, 0)})) == Rational(5));
  CHECK(gap_of(cubes({Vec3::Zero(), Vec3(2, 1, 0)})) == Rational(0));
  CHECK(gap_of(cubes({Vec3::Zero(), Vec3(1, 0, 0)})) == Rational(-1));
  CHECK(gap_of(cubes({Vec3::Zero(), Vec3::Zero()})) == Rational(-2));
  Dice dice(52);
  for (int i = 0; i < 300; ++i) gap_of(tests::hard_pair(i % tests::hard_families, dice));
}

}  // namespace
}  // namespace touchstone::reference
