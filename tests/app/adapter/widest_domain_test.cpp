// The measured domain of subjects whose boundaries are known.
#include "app/adapter/widest_domain.h"

#include <cmath>
#include <functional>

#include "oracle/subject.h"
#include "oracle/subjects/touchstone/reference.h"
#include "oracle/tolerance/tolerance.h"
#include "tests/app/changed_distances.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

/// The range of distance.value along the axis, if distances of scenes that are `wrong` are twice the true ones.
HeldRange measured(const std::string& axis, const std::function<bool(const Scene&)>& wrong) {
  const auto reference = oracle::subjects::make_reference();
  tests::ChangedDistances subject(*reference, [&](const Scene& scene, Distance& said) {
    if (wrong(scene)) *said.distance *= 2;
  });
  for (const HeldRange& range : widest_domain(subject, {"distance"}, [](const std::string&) {})) {
    if (range.property->id == "distance.value" && range.axis->name == axis) return range;
  }
  return {};
}

double thinnest(const Scene& scene) {
  double least = 1e300;
  for (const Body& body : scene.bodies) {
    if (const Box* box = std::get_if<Box>(&body.shape)) least = std::min(least, box->half_extents.minCoeff());
  }
  return least;
}

std::size_t vertices(const Scene& scene) {
  std::size_t most = 0;
  for (const Body& body : scene.bodies) {
    if (const Polytope* hull = std::get_if<Polytope>(&body.shape)) most = std::max(most, hull->vertices.size());
  }
  return most;
}

TEST_CASE("widest domain: lengths, of an engine that is wrong above 1000 m and below 1/1000 m") {
  const HeldRange found = measured("length", [](const Scene& scene) {
    const double scale = oracle::tolerance::scale(scene);
    return scale > 1000 || scale < 0.001;
  });
  CHECK(found.fails_below);
  CHECK(found.fails_above);
  // The plain scenes reach from 2 m to 20 m, and not all of them are separated.
  CHECK(found.most >= 5);
  CHECK(found.most <= 8);
  CHECK(found.least <= -10);
  CHECK(found.least >= -14);
}

TEST_CASE("widest domain: aspects, of an engine that is wrong for a half extent below 1/100 m") {
  const HeldRange found = measured("aspect", [](const Scene& scene) { return thinnest(scene) < 0.01; });
  CHECK(found.least == 0);
  CHECK(found.fails_above);
  CHECK_FALSE(found.fails_below);
  CHECK(found.most >= 5);
  CHECK(found.most <= 8);
}

TEST_CASE("widest domain: vertices, of an engine that is wrong above 40") {
  const HeldRange found = measured("vertices", [](const Scene& scene) { return vertices(scene) > 40; });
  CHECK(found.least == 3);
  CHECK(found.most == 5);
  CHECK(found.fails_above);
}

TEST_CASE("widest domain: nothing ends where nothing is wrong, and nothing holds where all is") {
  const HeldRange right = measured("length", [](const Scene&) { return false; });
  CHECK(right.least == -40);
  CHECK(right.most == 40);
  CHECK_FALSE(right.fails_above);
  const HeldRange wrong = measured("length", [](const Scene&) { return true; });
  CHECK(wrong.least > wrong.most);
  CHECK(wrong.fails_above);
}

TEST_CASE("default domain: 250 ulps of the reach are at most 2^-10 of the thinnest body") {
  for (const auto& [precision, u] :
       {std::pair(oracle::Precision::binary32, 0x1p-24), {oracle::Precision::binary64, 0x1p-53}}) {
    const oracle::Domain domain = default_domain(precision);
    CHECK(250 * u * *domain.reach <= 0x1p-10 * domain.lengths->lo);
    CHECK(8 * 250 * u * *domain.reach > 0x1p-10 * domain.lengths->lo);
    CHECK(*domain.aspect == domain.lengths->hi / domain.lengths->lo);
    CHECK(*domain.mass_ratio == 0x1p-10 / u);
  }
}

}  // namespace
}  // namespace touchstone::app
