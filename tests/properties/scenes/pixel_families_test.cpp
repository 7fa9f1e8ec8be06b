// The family of wide rasters reaches what it is for: counted from the reference's masks.
#include <algorithm>
#include <string>

#include "oracle/truth/truth.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"

using namespace touchstone;

TEST_CASE("drawn pixels: pixels.wide covers all of more than 2,048 columns") {
  int wide = 0, covered_twice = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Scene scene = properties::draw(properties::find_family("pixels.wide"), 5, i);
    const Pixels& truth = oracle::truth::pixel(scene);
    const std::string all(static_cast<std::size_t>(scene.raster->columns), '1');
    const auto is_full = [&](const Mask& mask) { return std::ranges::count(mask, all) == scene.raster->rows; };
    const int full = is_full(truth.sampled[0]) + is_full(truth.sampled[1]);
    CHECK(full >= 1);
    if (scene.raster->columns <= 2048) continue;
    ++wide;
    covered_twice += full == 2;
  }
  CHECK(wide >= 20);
  CHECK(covered_twice >= 4);
}
