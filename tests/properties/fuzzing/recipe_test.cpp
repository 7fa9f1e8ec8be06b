// Any bytes are a valid scene, and the mutators of recipes keep to their lengths.
#include "properties/fuzzing/recipe.h"

#include "oracle/truth/truth.h"
#include "properties/property.h"
#include "properties/random.h"
#include "tests/catch.h"

namespace touchstone::properties::fuzzing {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes random_bytes(std::size_t size, Random& random) {
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

TEST_CASE("Random bytes of any length are a valid scene for every query, and the same one each time") {
  for (const std::string& query : tested_queries()) {
    Random random(1, query, 0);
    for (const std::size_t size : {0, 1, 3, 4, 5, 12, 13, 40, 132, 500}) {
      for (int round = 0; round < 3; ++round) {
        const Bytes bytes = random_bytes(size, random);
        INFO(query << ", " << size << " bytes");
        const Scene scene = scene_of(query, bytes);
        CHECK(oracle::truth::completed(scene) == scene);
        CHECK(scene_of(query, bytes) == scene);
      }
    }
  }
}

TEST_CASE("Bytes after the last mutation do not count") {
  Random random(2);
  Bytes bytes = random_bytes(most_bytes, random);
  const Scene scene = scene_of("distance", bytes);
  bytes.push_back(17);
  CHECK(scene_of("distance", bytes) == scene);
}

TEST_CASE("A mutated recipe is another one, within its length") {
  Bytes recipe;
  int others = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Bytes before = recipe;
    const std::size_t most = seed < 100 ? 60 : most_bytes;
    mutate_recipe(recipe, most, seed);
    CHECK(recipe.size() <= most);
    others += recipe != before;
  }
  CHECK(others > 290);
  mutate_recipe(recipe, 2, 1);
  CHECK(recipe.size() <= 2);
}

TEST_CASE("Crossed recipes begin as the first, and are as long as allowed") {
  Random random(3);
  const Bytes a = random_bytes(60, random), b = random_bytes(100, random);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Bytes both = crossed(a, b, 80, seed);
    CHECK(both.size() <= 80);
    CHECK(Bytes(both.begin(), both.begin() + bytes_of_start) == Bytes(a.begin(), a.begin() + bytes_of_start));
  }
  CHECK(crossed({}, {}, 80, 1).size() <= bytes_of_start);
}

}  // namespace
}  // namespace touchstone::properties::fuzzing
