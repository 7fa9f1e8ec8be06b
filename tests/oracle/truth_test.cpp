#include "oracle/truth/truth.h"

#include "model/input_error.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

Scene cubes(double gap) {
  Scene scene;
  scene.bodies.resize(2);
  for (Body& body : scene.bodies) body.shape = Box{Vec3::Ones()};
  scene.bodies[1].X_WB.p_WB = {2 + gap, 0, 0};
  return scene;
}

TEST_CASE("The truth is asked through the memory and is the reference's") {
  CHECK(truth::distance(cubes(1)).core_squared == reference::Rational(1));
  CHECK(truth::penetration(cubes(-1)).core_squared == reference::Rational(1));
  CHECK(truth::broad_phase(cubes(0)) == PairSet{{0, 1}});
  CHECK(truth::bounds(cubes(3))[1].lo[0] == reference::Rational(4));
  CHECK(truth::mass(cubes(0))[0]->mass == Interval{8, 8});
}

TEST_CASE("A truth stays where it is until eight other scenes were asked about") {
  const auto* first = &truth::distance(cubes(0.5));
  for (int i = 1; i < truth::remembered; ++i) truth::distance(cubes(i));
  CHECK(&truth::distance(cubes(0.5)) == first);
  for (int i = 1; i < truth::remembered; ++i) truth::distance(cubes(-0.125 * i));
  CHECK(first->core_squared == reference::Rational(0.25));
}

TEST_CASE("What the reference refuses is refused, and not remembered") {
  Scene flat = cubes(1);
  flat.bodies[0].shape = Polytope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {}};
  CHECK_THROWS_AS(truth::completed(flat), InputError);
  CHECK_THROWS_AS(truth::completed(flat), InputError);
}

}  // namespace
}  // namespace touchstone::oracle
