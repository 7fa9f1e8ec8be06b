#include "fast/simulation/prediction/length.h"

#include "tests/catch.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("length: exact where the squares are") {
  CHECK(length({3, 4, 12}) == 13);
  CHECK(length({-2, 3, -6}) == 7);
  CHECK(length(Vec3::Zero()) == 0);
}

}  // namespace
}  // namespace touchstone::fast::simulation
