// The scenes that a seed draws: the same bits from every build and every version, unless a change means otherwise.
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "model/json.h"
#include "properties/scenes/extreme.h"
#include "tests/catch.h"

namespace touchstone::properties {
namespace {

constexpr std::uint64_t seed = 1, draws = 128, draws_of_many_bodies = 32;

/// FNV-1a.
std::uint64_t digest(const std::string& text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

/// One line a family, with the digest of its first scenes as JSON text.
std::string digests(const std::vector<Family>& of) {
  std::string page;
  for (const Family& family : of) {
    const bool is_large = draw(family, seed, 0).bodies.size() > 16;
    std::string scenes;
    for (std::uint64_t i = 0; i < (is_large ? draws_of_many_bodies : draws); ++i)
      scenes += json_of(draw(family, seed, i)).dump();
    char line[17];
    std::snprintf(line, sizeof line, "%016llx", static_cast<unsigned long long>(digest(scenes)));
    page += family.id + ' ' + line + '\n';
  }
  return page;
}

std::vector<std::string> lines_not_in(const std::string& page, const std::string& of) {
  std::istringstream lines(of);
  std::vector<std::string> missing;
  for (std::string line; std::getline(lines, line);) {
    if (page.find(line + '\n') == std::string::npos) missing.push_back(line);
  }
  return missing;
}

}  // namespace

// A seed in somebody's report must draw the same scene again, with another compiler (the order of two draws in one
// expression would depend on it) and in the next version. The digests are a regression pin. A change of a family needs
// a reason, and makes seeds of older reports draw other scenes. To make them anew: TOUCHSTONE_UPDATE=1 ./touchstone
// test -R "digests are pinned".
TEST_CASE("families: the scenes of a seed and their digests are pinned") {
  const std::string path = TOUCHSTONE_SOURCE_DIR "/tests/properties/scenes/drawn_scenes.txt";
  const std::string now = digests(families()) + digests(extremes());
  if (std::getenv("TOUCHSTONE_UPDATE") != nullptr) write_text(path, now);
  CHECK(lines_not_in(read_text(path), now) == std::vector<std::string>{});
  CHECK(lines_not_in(now, read_text(path)) == std::vector<std::string>{});
}

}  // namespace touchstone::properties
