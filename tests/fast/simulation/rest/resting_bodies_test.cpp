#include "fast/simulation/rest/resting_bodies.h"

#include "tests/catch.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("resting bodies: each body rests on one other at most") {
  RestingBodies rests(3);
  CHECK(rests.of(1) == nullptr);
  CHECK_FALSE(rests.rests_on(1, 0));
  RestingContact rest;
  rest.on = 2;
  rest.until = 5;
  rests.set(1, rest);
  REQUIRE(rests.of(1) != nullptr);
  CHECK(rests.of(1)->until == 5);
  CHECK(rests.rests_on(1, 2));
  CHECK_FALSE(rests.rests_on(1, 0));
  CHECK_FALSE(rests.rests_on(2, 1));
  rests.erase(1);
  CHECK(rests.of(1) == nullptr);
}

}  // namespace
}  // namespace touchstone::fast::simulation
