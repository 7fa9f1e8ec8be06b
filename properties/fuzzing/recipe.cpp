#include "properties/fuzzing/recipe.h"

#include <algorithm>

#include "properties/fuzzing/mutate.h"
#include "properties/scenes/domain.h"

namespace touchstone::properties::fuzzing {
namespace {

/// The number in the bytes from `at`, the lowest byte first.
std::uint64_t number(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t count) {
  std::uint64_t all = 0;
  for (std::size_t i = count; i-- > 0;) all = all << 8 | (at + i < bytes.size() ? bytes[at + i] : 0);
  return all;
}

std::size_t mutations_of(std::span<const std::uint8_t> recipe) {
  if (recipe.size() <= bytes_of_start) return 0;
  return std::min((recipe.size() - bytes_of_start + bytes_of_mutation - 1) / bytes_of_mutation, most_mutations);
}

std::size_t begin_of(std::size_t mutation) { return bytes_of_start + mutation * bytes_of_mutation; }

Scene drawn(const std::string& query, std::uint64_t choice) {
  const std::vector<const Family*> chosen = for_query(families(), query);
  return draw(*chosen[choice % chosen.size()], 1, choice / chosen.size() % 256);
}

void write_random(std::vector<std::uint8_t>& recipe, std::size_t begin, std::size_t count, Random& random) {
  for (std::size_t i = begin; i < begin + count; ++i) recipe[i] = static_cast<std::uint8_t>(random.below(256));
}

}  // namespace

Scene scene_of(const std::string& query, std::span<const std::uint8_t> recipe) {
  Scene scene = drawn(query, number(recipe, 0, bytes_of_start));
  const oracle::Query& asked = *oracle::find_query(query);
  for (std::size_t m = 0; m < mutations_of(recipe); ++m) {
    Random random(number(recipe, begin_of(m), bytes_of_mutation));
    const Scene other = drawn(query, random.bits());
    scene = mutated(scene, other, asked, random);
  }
  return scene;
}

void mutate_recipe(std::vector<std::uint8_t>& recipe, std::size_t most, std::uint64_t seed) {
  Random random(seed);
  const std::size_t end = std::min(most, most_bytes);
  const std::size_t room = end < bytes_of_start ? 0 : (end - bytes_of_start) / bytes_of_mutation;
  const std::size_t mutations = std::min(mutations_of(recipe), room);
  recipe.resize(std::min(end, begin_of(mutations)));
  const int way = random.below(8);
  if (way == 0 || recipe.size() < bytes_of_start) {
    recipe.resize(std::min(end, std::max(recipe.size(), bytes_of_start)));
    write_random(recipe, 0, std::min(recipe.size(), bytes_of_start), random);
  } else if (way == 1 && mutations > 0) {
    recipe.resize(begin_of(mutations - 1));
  } else if ((way <= 3 || mutations == room) && mutations > 0) {
    const auto m = random.index(mutations);
    write_random(recipe, begin_of(m), bytes_of_mutation, random);
  } else if (mutations < room) {
    recipe.resize(begin_of(mutations + 1));
    write_random(recipe, begin_of(mutations), bytes_of_mutation, random);
  }
}

std::vector<std::uint8_t> crossed(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::size_t most,
                                  std::uint64_t seed) {
  Random random(seed);
  const auto kept = static_cast<std::size_t>(random.between(0, static_cast<int>(mutations_of(a))));
  const auto from = static_cast<std::size_t>(random.between(0, static_cast<int>(mutations_of(b))));
  std::vector<std::uint8_t> both(a.begin(),
                                 a.begin() + static_cast<std::ptrdiff_t>(std::min(a.size(), begin_of(kept))));
  const std::size_t cut = std::min(b.size(), begin_of(from));
  both.resize(begin_of(kept));
  both.insert(both.end(), b.begin() + static_cast<std::ptrdiff_t>(cut), b.end());
  both.resize(std::min({both.size(), most, most_bytes}));
  return both;
}

}  // namespace touchstone::properties::fuzzing
