// The scenes that a seed draws: the same bits from every build and every version, unless a change means otherwise.
#include "model/json.h"
#include "properties/fuzzing/recipe.h"
#include "properties/property.h"
#include "properties/scenes/extreme.h"
#include "tests/catch.h"
#include "tests/properties/pins/pinned_page.h"

namespace touchstone::properties {
namespace {

constexpr std::uint64_t seed = 1, draws = 128, draws_of_many_bodies = 32;

/// One line a family, with the digest of its first scenes as JSON text.
std::string digests(const std::vector<Family>& of) {
  std::string page;
  for (const Family& family : of) {
    const bool is_large = draw(family, seed, 0).bodies.size() > 16;
    tests::Digest scenes;
    for (std::uint64_t i = 0; i < (is_large ? draws_of_many_bodies : draws); ++i)
      scenes.add(json_of(draw(family, seed, i)).dump());
    page += family.id + ' ' + scenes.text() + '\n';
  }
  return page;
}

/// One line a query, with the digest of the scenes of random recipes, and of the recipes that they mutate into.
std::string digests_of_recipes() {
  std::string page;
  for (const std::string& query : tested_queries()) {
    Random random(seed, query, 0);
    tests::Digest scenes;
    for (std::uint64_t i = 0; i < draws; ++i) {
      std::vector<std::uint8_t> recipe(fuzzing::most_bytes / 2);
      for (std::uint8_t& byte : recipe) byte = static_cast<std::uint8_t>(random.below(256));
      scenes.add(json_of(fuzzing::scene_of(query, recipe)).dump());
      fuzzing::mutate_recipe(recipe, fuzzing::most_bytes, i);
      scenes.add(std::string(recipe.begin(), recipe.end()));
    }
    page += "recipes of " + query + ' ' + scenes.text() + '\n';
  }
  return page;
}

}  // namespace

// A seed in somebody's report must draw the same scene again, with another compiler (the order of two draws in one
// expression would depend on it) and in the next version. The digests are a regression pin. A change of a family needs
// a reason, and makes seeds of older reports draw other scenes. To make them anew: TOUCHSTONE_UPDATE=1 ./touchstone
// test -R "pins:".
TEST_CASE("pins: the scenes of a seed") {
  const std::string now = digests(families()) + digests(extremes()) + digests_of_recipes();
  CHECK(tests::changed_lines("scenes.txt", now) == std::vector<std::string>{});
}

}  // namespace touchstone::properties
