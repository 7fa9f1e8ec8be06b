#include "model/near_names.h"

#include "tests/catch.h"

namespace touchstone {
namespace {

const std::vector<std::string> queries = {"mass", "bounds", "broad_phase", "distance", "penetration", "time_of_impact"};

TEST_CASE("near names: slips of the fingers") {
  CHECK(did_you_mean("distanse", queries) == "did you mean distance?");
  CHECK(did_you_mean("boudns", queries) == "did you mean bounds?");
  CHECK(did_you_mean("Mass", queries) == "did you mean mass?");
  CHECK(did_you_mean("aks", {"ask", "list"}) == "");  // two of three letters
  CHECK(did_you_mean("lits", {"ask", "list"}) == "did you mean list?");
}

TEST_CASE("near names: a part of a name, or more than it") {
  CHECK(did_you_mean("impact", queries) == "did you mean time_of_impact?");
  CHECK(did_you_mean("bulet", {"bullet.double", "bullet.float", "fast"}) ==
        "did you mean bullet.float or bullet.double?");
  CHECK(did_you_mean("motion_turntable", {"turntable", "gas"}) == "did you mean turntable?");
}

TEST_CASE("near names: nearest first, at most three") {
  CHECK(did_you_mean("gas", {"gas_of_many", "gas_4", "gas_1", "gas_10"}) == "did you mean gas_1, gas_4 or gas_10?");
}

TEST_CASE("near names: nothing is near") {
  CHECK(did_you_mean("depth", queries) == "");
  CHECK(did_you_mean("", queries) == "");
  CHECK(did_you_mean("x", {}) == "");
  CHECK(did_you_mean(std::string(100'000'000, 'm') + "ass", queries) == "");
}

TEST_CASE("near names: with all that there are") {
  CHECK(unknown_among("mas", {"mass", "bounds"}) == "unknown; did you mean mass? There are mass, bounds");
  CHECK(unknown_among("depth", {"mass", "bounds"}) == "unknown; there are mass, bounds");
}

}  // namespace
}  // namespace touchstone
