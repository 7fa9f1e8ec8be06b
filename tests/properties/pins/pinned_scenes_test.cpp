// The scenes that a seed draws: the same bits from every build and every version, unless a change means otherwise.
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

}  // namespace

// A seed in somebody's report must draw the same scene again, with another compiler (the order of two draws in one
// expression would depend on it) and in the next version. The digests are a regression pin. A change of a family needs
// a reason, and makes seeds of older reports draw other scenes. To make them anew: TOUCHSTONE_UPDATE=1 ./touchstone
// test -R "pins:".
TEST_CASE("pins: the scenes of a seed") {
  const std::string now = digests(families()) + digests(extremes()), pinned = tests::pinned_page("scenes.txt", now);
  CHECK(tests::lines_not_in(pinned, now) == std::vector<std::string>{});
  CHECK(tests::lines_not_in(now, pinned) == std::vector<std::string>{});
}

}  // namespace touchstone::properties
