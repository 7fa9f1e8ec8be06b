// Fast pixels against the exact ones, on scenes that are hard for other reasons and on scenes made for pixels.
#include "fast/pixel.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "fast/pixel/bit_mask.h"
#include "model/input_error.h"
#include "properties/scenes/domain.h"
#include "reference/pixel.h"
#include "tests/catch.h"

using namespace touchstone;

namespace {

bool holds(const Mask& wide, const Mask& exact) {
  for (std::size_t j = 0; j < exact.size(); ++j) {
    for (std::size_t i = 0; i < exact[j].size(); ++i) {
      if (exact[j][i] == '1' && wide[j][i] != '1') return false;
    }
  }
  return true;
}

void check_against_the_reference(const Scene& scene) {
  const Pixels exact = reference::pixel(scene);
  const Pixels said = fast::pixels(scene);
  CHECK(said.sampled == exact.sampled);
  CHECK(said.overlap == exact.overlap);
  CHECK(said.meet_sampled == exact.meet_sampled);
  REQUIRE(said.conservative.size() == exact.conservative.size());
  for (std::size_t b = 0; b < exact.conservative.size(); ++b) {
    CHECK(holds(said.conservative[b], exact.conservative[b]));
  }
  CHECK(holds(said.meet_conservative, exact.meet_conservative));
}

/// A raster somewhere over the first body.
Raster some_raster(properties::Random& random, const Body& body) {
  Raster raster;
  raster.pixel = std::ldexp(1.0, random.between(-5, 1));
  raster.columns = random.between(1, 20);
  raster.rows = random.between(1, 20);
  const double across = random.whole(0, 20);
  const double up = random.whole(0, 20) - (random.one_in(2) ? random.unit() : 0);
  raster.x = body.X_WB.p_WB.x() - raster.pixel * across;
  raster.y = body.X_WB.p_WB.y() - raster.pixel * up;
  return raster;
}

}  // namespace

TEST_CASE("fast pixels are the exact ones, over the families of pairs") {
  for (const properties::Family& family : properties::families()) {
    for (std::uint64_t index = 0; index < 8; ++index) {
      Scene scene = properties::draw(family, 6, index);
      if (scene.bodies.empty() || scene.bodies.size() > 4 || !scene.frames.empty()) continue;
      properties::Random random(6, family.id, 1000 + index);
      if (!scene.raster) scene.raster = some_raster(random, scene.bodies.front());
      INFO(family.id << ' ' << index);
      check_against_the_reference(scene);
    }
  }
}

TEST_CASE("word-parallel overlap is bit by bit overlap, at every shift around the words' borders") {
  properties::Random random(3);
  for (const int columns : {1, 63, 64, 65, 130}) {
    const int rows = 5;
    fast::pixel::BitMask A(columns, rows);
    fast::pixel::BitMask B(columns, rows);
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        if (random.one_in(9)) A.set(i, j);
        if (random.one_in(9)) B.set(i, j);
      }
    }
    for (int shift_y = -rows; shift_y <= rows; ++shift_y) {
      for (int shift_x = -columns - 1; shift_x <= columns + 1; ++shift_x) {
        MaskOverlap expected;
        for (int j = 0; j < rows; ++j) {
          for (int i = 0; i < columns; ++i) {
            const int c = i - shift_x;
            const int r = j - shift_y;
            if (c < 0 || c >= columns || r < 0 || r >= rows || !A.at(i, j) || !B.at(c, r)) continue;
            if (expected.count++ == 0) expected.first = {i, j};
          }
        }
        REQUIRE(fast::pixel::overlap(A, B, shift_x, shift_y) == expected);
      }
    }
    for (const int far : {std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
      CHECK(fast::pixel::overlap(A, B, far, 0) == MaskOverlap{});
      CHECK(fast::pixel::overlap(A, B, 0, far) == MaskOverlap{});
    }
  }
}

TEST_CASE("lengths at the ends of the range") {
  Scene scene;
  scene.bodies.resize(2);
  for (const double unit : {0x1p-1000, 0x1p-300, 0x1p300, 0x1p900}) {
    scene.bodies[0].shape = Box{unit * Vec3(1, 2, 3)};
    scene.bodies[0].X_WB.q_WB = {3, 1, -2, 1};
    scene.bodies[1].shape = Sphere{unit};
    scene.bodies[1].X_WB.p_WB = unit * Vec3(2, 1, 1);
    scene.raster = Raster{-4 * unit, -4 * unit, unit / 2, 16, 16, 1, -1};
    INFO(unit);
    Scene complete = scene;
    check_against_the_reference(complete);
  }
  scene.bodies[1].shape = Sphere{0x1p1001};
  CHECK_THROWS_AS(fast::pixels(scene), std::range_error);
  scene.raster.reset();
  CHECK_THROWS_AS(fast::pixels(scene), InputError);
}
