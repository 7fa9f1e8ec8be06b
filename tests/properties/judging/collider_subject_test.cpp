// The collider of fast as a subject: Lin and Canny's walk, which fast::distance does not take.
#include <string>

#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast_collider.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"
#include "tests/properties/scenes.h"

namespace touchstone::properties {
namespace {

constexpr int scenes_of_a_family = 6;

TEST_CASE("the collider holds every property of distance in scenes of each family") {
  for (const char* name : {"collider", "collider_first"}) {
    const auto collider = oracle::subjects::make_fast_collider(name);
    for (const Family* family : for_query(families(), "distance")) {
      for (int i = 0; i < scenes_of_a_family; ++i) {
        const Scene scene = draw(*family, 3, static_cast<std::uint64_t>(i));
        for (const Property& property : all()) {
          if (property.query != "distance") continue;
          const oracle::Finding found = property.check(scene, *collider);
          INFO(property.id << " of " << collider->card().name << ", " << family->id << ' ' << i << ": "
                           << found.observed);
          CHECK(!oracle::failed(found));
        }
      }
    }
  }
}

// Cubes of side 2, B at (0.5, 2.25, 0.25): their faces are a quarter apart.
TEST_CASE("the collider walks, in both frames, and names the features where it ends") {
  const Scene& scene = tests::scene("cubes apart along y");
  for (const char* name : {"collider", "collider_first"}) {
    const auto collider = oracle::subjects::make_fast_collider(name);
    const auto work = collider->work("distance", scene);
    CHECK(std::get<oracle::Work>(work).at("walk") == (std::string(name) == "collider" ? 2 : 1));
    const auto answer = collider->distance(scene);
    const auto& said = std::get<Distance>(answer);
    CHECK(said.verdict == Verdict::separated);
    CHECK(said.distance == 0.25);
    REQUIRE(said.feature_A);
    REQUIRE(said.feature_B);
    CHECK(said.feature_A->vertices.size() + said.feature_B->vertices.size() >= 4);
  }
}

}  // namespace
}  // namespace touchstone::properties
