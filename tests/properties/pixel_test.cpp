// The outcomes of the pixel properties, for answers computed by hand.
#include <limits>

#include "oracle/minimise/minimise.h"
#include "oracle/truth/truth.h"
#include "properties/property.h"
#include "properties/transforms/raster.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;

namespace {

const char* const cubes = "cubes with sides through centres, one on the other";

oracle::Finding judged(const std::string& property, Answer<Pixels> said, const std::string& scene = cubes) {
  tests::FixedSubject subject;
  subject.said_pixels = std::move(said);
  return properties::find(property).check(tests::scene(scene), subject);
}

Pixels truth(const std::string& scene = cubes) { return oracle::truth::pixel(tests::scene(scene)); }

}  // namespace

TEST_CASE("pixel: the scene by hand") {
  // [-1, 1]² and [0, 2] × [-1, 1], pixel centres at -2, -1, 0, 1, 2, 3; B's mask is shifted right by one.
  const Mask row = {"000000", "011100", "011100", "011100", "000000", "000000"};
  CHECK(truth().sampled[0] == row);
  CHECK(truth().overlap == MaskOverlap{3, std::pair{3, 1}});
  CHECK(truth().meet_sampled == Mask{"000000", "001100", "001100", "001100", "000000", "000000"});
}

TEST_CASE("pixel.sampled: not one pixel more or less") {
  CHECK(judged("pixel.sampled", truth()).outcome == Outcome::holds);
  Pixels said = truth();
  said.sampled[1][1][2] = '0';
  CHECK(judged("pixel.sampled", said).defect == Defect::missed);
  said = truth();
  said.sampled[1][0][0] = '1';
  CHECK(judged("pixel.sampled", said).defect == Defect::phantom);
  CHECK(judged("pixel.sampled", truth(), "cubes apart along y").outcome == Outcome::outside);
  CHECK(judged("pixel.sampled", Abstains{"no"}).outcome == Outcome::abstains);
}

TEST_CASE("pixel.conservative and pixel.narrow: nothing left out, and one pixel too many at most") {
  Pixels said = truth();  // A: columns and rows 1 to 3. Grid lines are at halves, so no other square overlaps
  CHECK(said.conservative[0][2] == "011100");
  said.conservative[0][2] = "111110";
  CHECK(judged("pixel.conservative", said).outcome == Outcome::holds);
  CHECK(judged("pixel.narrow", said).outcome == Outcome::holds);
  said.conservative[0][2] = "111111";
  CHECK(judged("pixel.narrow", said).defect == Defect::loose_box);
  said.conservative[0][2] = "011000";
  CHECK(judged("pixel.conservative", said).defect == Defect::missed);
}

// 2^36 m from the origin doubles are 2^-17 m apart, and rounding is more than 2^-17 · 2^7 m.
TEST_CASE("pixel.narrow and pixel.comes_near: pixels that are far smaller than rounding are not judged") {
  const auto outcomes = [](double pixel) {
    Scene scene;
    scene.bodies.resize(2);
    for (Body& body : scene.bodies) {
      body.shape = Sphere{1};
      body.X_WB.p_WB = {0x1p36, 1 + 0x1p-10, 0};
    }
    scene.raster = Raster{.x = 0x1p36, .y = 0, .pixel = pixel, .columns = 1, .rows = 1};
    Pixels said = oracle::truth::pixel(scene);
    const Mask nothing = {"0"}, all = {"1"};
    CHECK(said.conservative[0] == nothing);
    said.conservative = {all, all};
    said.meet_conservative = all;
    tests::FixedSubject subject;
    subject.said_pixels = said;
    return std::pair(properties::find("pixel.narrow").check(scene, subject).outcome,
                     properties::find("pixel.comes_near").check(scene, subject).outcome);
  };
  CHECK(outcomes(0x1p-46) == std::pair(Outcome::outside, Outcome::outside));
  CHECK(outcomes(0x1p-12) == std::pair(Outcome::holds, Outcome::holds));
}

TEST_CASE("pixel.overlap and pixel.counts: the truth's, and one's own masks'") {
  Pixels said = truth();
  said.overlap.count = 4;
  CHECK(judged("pixel.overlap", said).defect == Defect::phantom);
  CHECK(judged("pixel.counts", said).defect == Defect::inconsistent);
  said = truth();
  said.sampled[0][1] = "011000";  // then its own masks have two in common
  said.overlap = {2, std::pair{3, 2}};
  CHECK(judged("pixel.counts", said).outcome == Outcome::holds);
  CHECK(judged("pixel.overlap", said).defect == Defect::missed);
}

TEST_CASE("pixel.meet, pixel.may_meet and pixel.comes_near: depth decides") {
  const std::string apart = "cubes apart, one above the other";
  CHECK(judged("pixel.meet", truth(apart), apart).outcome == Outcome::holds);
  CHECK(judged("pixel.comes_near", truth(apart), apart).outcome == Outcome::holds);
  Pixels said = truth(apart);
  said.meet_conservative = said.conservative[0];
  CHECK(judged("pixel.comes_near", said, apart).defect == Defect::phantom);
  CHECK(judged("pixel.may_meet", said, apart).outcome == Outcome::holds);
  said = truth();
  said.meet_conservative[1][2] = '0';
  CHECK(judged("pixel.may_meet", said).defect == Defect::missed);
  CHECK(judged("pixel.bracket", said).defect == Defect::inconsistent);
  said = truth();
  said.meet_sampled[1][2] = '0';
  CHECK(judged("pixel.meet", said).defect == Defect::missed);
}

TEST_CASE("pixel: masks of another number, size or alphabet mean nothing") {
  for (const auto& spoil : std::vector<void (*)(Pixels&)>{
           [](Pixels& p) { p.sampled.pop_back(); }, [](Pixels& p) { p.conservative[0].pop_back(); },
           [](Pixels& p) { p.meet_sampled[0] += '0'; }, [](Pixels& p) { p.meet_conservative[0][0] = '2'; }}) {
    Pixels said = truth();
    spoil(said);
    CHECK(judged("pixel.survives", said).defect == Defect::garbage);
  }
}

TEST_CASE("pixel laws: a constant cannot follow what moves") {
  for (const char* law : {"pixel.symmetric", "pixel.stepped", "pixel.shifted"}) {
    INFO(law);
    CHECK(judged(law, truth()).outcome == Outcome::fails);
  }
  CHECK(judged("pixel.translated", truth()).outcome == Outcome::holds);  // a constant answer is right here
}

/// Right about scenes of some size, and about all others as if nothing were above any pixel.
struct RightAboutSizes : tests::FixedSubject {
  double least = 0, greatest = 0;  // m, of a pixel

  Answer<Pixels> pixel(const Scene& scene) override {
    Pixels said = oracle::truth::pixel(scene);
    if (scene.raster->pixel < least || scene.raster->pixel > greatest) {
      for (std::string& row : said.meet_sampled) row.assign(row.size(), '0');
    }
    return said;
  }
};

TEST_CASE("pixel.scaled: an absolute tolerance shows in small scenes or in great ones") {
  const auto scaled = [](double least, double greatest) {
    RightAboutSizes subject;
    subject.least = least;
    subject.greatest = greatest;
    return properties::find("pixel.scaled").check(tests::scene(cubes), subject);
  };
  CHECK(scaled(0x1p-30, 0x1p30).outcome == Outcome::holds);
  CHECK(scaled(0x1p-10, 0x1p30).defect == Defect::scaled);
  CHECK(scaled(0x1p-30, 0x1p10).defect == Defect::scaled);
}

TEST_CASE("motions of rasters are exact or none") {
  Scene scene = tests::scene(cubes);
  const auto moved = properties::moved_by_pixels(scene, {1}, 3, -2);
  REQUIRE(moved);
  CHECK(moved->bodies[1].X_WB.p_WB == Vec3(4, -2, 2));
  CHECK(moved->bodies[0] == scene.bodies[0]);
  scene.raster->pixel = 0x1p-60;
  CHECK_FALSE(properties::moved_by_pixels(scene, {1}, 1, 0));
  Raster raster{0.1, 0, 1, 2, 2, std::numeric_limits<int>::min(), 5};
  CHECK(properties::with_opposite_shift(raster).shift_x == std::numeric_limits<int>::max());
  CHECK(properties::with_opposite_shift(raster).shift_y == -5);
  CHECK_FALSE(properties::translated(raster, Vec3(1e9, 0, 0)));
  CHECK_FALSE(properties::scaled(Raster{1, 1, 0x1p-1070, 1, 1, 0, 0}, -20));
  CHECK(properties::scaled(raster, 20)->pixel == 0x1p20);
}

TEST_CASE("a minimised scene keeps no pixel that it does not need") {
  const Scene& scene = tests::scene("turned bodies under a raster");
  const Scene smallest = oracle::minimise(
      scene,
      [](const Scene& s) { return s.raster && oracle::truth::pixel(s).sampled[0][0].find('1') != std::string::npos; },
      2000);
  REQUIRE(smallest.raster);
  CHECK(smallest.raster->columns == 1);
  CHECK(smallest.raster->rows == 1);
  CHECK(smallest.raster->shift_x == 0);
  const Scene without = oracle::minimise(
      scene, [](const Scene& s) { return s.bodies.size() == 2; }, 2000);
  CHECK_FALSE(without.raster);
}
