// Pairs of bodies that fast follows, as subjects: Lin and Canny's walk, which fast::distance does not take, and depths
// whose search starts from the last one.
#include "oracle/subjects/touchstone/fast_pairs.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>

#include "oracle/subject.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"
#include "tests/properties/scenes.h"

namespace touchstone::properties {
namespace {

constexpr std::uint64_t scenes_of_a_family = 6;

TEST_CASE("pairs that are followed hold every property in scenes of each family") {
  for (const char* name : {"warm", "cold"}) {
    const auto pairs = oracle::subjects::make_fast_pairs(name);
    for (const Property& property : all()) {
      if (std::ranges::count(pairs->card().answers, property.query) == 0) continue;
      for (const Family* family : for_query(families(), property.query)) {
        for (std::uint64_t i = 0; i < scenes_of_a_family; ++i) {
          const oracle::Finding found = property.check(draw(*family, 3, i), *pairs);
          INFO(property.id << " of " << pairs->card().name << ", " << family->id << ' ' << i << ": " << found.observed);
          CHECK(!oracle::failed(found));
        }
      }
    }
  }
}

// Cubes of side 2, B at (0.5, 2.25, 0.25): their faces are a quarter apart.
TEST_CASE("the collider walks in each frame, and names the features where it ends") {
  const Scene& scene = tests::scene("cubes apart along y");
  for (const char* name : {"warm", "cold"}) {
    const auto pairs = oracle::subjects::make_fast_pairs(name);
    const auto work = pairs->work("distance", scene);
    CHECK(std::get<oracle::Work>(work).at("walk") == (std::string(name) == "warm" ? 2 : 1));
    const auto answer = pairs->distance(scene);
    const auto& said = std::get<Distance>(answer);
    CHECK(said.verdict == Verdict::separated);
    CHECK(said.distance == 0.25);
    REQUIRE(said.feature_A);
    REQUIRE(said.feature_B);
    CHECK(said.feature_A->vertices.size() + said.feature_B->vertices.size() >= 4);
  }
}

TEST_CASE("pairs that are followed answer far away, and say what they do not answer") {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = scene.bodies[1].shape = Sphere{1};
  scene.bodies[1].X_WB.p_WB.x() = 0x1p990;
  scene.bodies[1].X_WB.q_WB = {1.7e308, 1.7e308, 1e308, -1.7e308};
  for (const char* name : {"warm", "cold"}) {
    const auto pairs = oracle::subjects::make_fast_pairs(name);
    CHECK(std::get<Distance>(pairs->distance(scene)).distance == 0x1p990);
    Scene compound = scene;
    compound.bodies[0].shape = Compound{{Part{{}, Sphere{1}}}};
    CHECK(std::holds_alternative<Abstains>(pairs->penetration(compound)));
    Scene lone = scene;
    lone.bodies.resize(1);
    CHECK(std::holds_alternative<Abstains>(pairs->distance(lone)));
    CHECK(std::holds_alternative<Abstains>(pairs->penetration(lone)));
  }
}

}  // namespace
}  // namespace touchstone::properties
