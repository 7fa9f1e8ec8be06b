#include "properties/random.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "tests/catch.h"

using touchstone::properties::Random;

TEST_CASE("The generator is xoshiro256** filled by SplitMix64: its first numbers as an independent program has them") {
  Random random(1234567);
  const std::array<std::uint64_t, 4> expected = {0x30a3a1c363600467, 0x19405f0f579929ca, 0x115beaac046ddbd9,
                                                 0xeb17caf48f27d7f6};
  for (const std::uint64_t number : expected) CHECK(random.bits() == number);
}

TEST_CASE("Seed, name and index each make another stream") {
  const auto first = [](std::uint64_t seed, const char* name, std::uint64_t index) {
    return Random(seed, name, index).bits();
  };
  CHECK(first(1, "a", 2) == first(1, "a", 2));
  CHECK(first(1, "a", 2) != first(2, "a", 1));
  CHECK(first(1, "a", 2) != first(1, "b", 2));
  CHECK(first(0, "", 0) != first(0, "", 1));
}

TEST_CASE("below and between reach every value about equally often") {
  Random random(7);
  std::array<int, 6> count{};
  for (int i = 0; i < 60000; ++i) ++count[static_cast<std::size_t>(random.between(-2, 3) + 2)];
  for (const int n : count) CHECK(std::abs(n - 10000) < 500);  // five standard deviations are 456
  CHECK(random.below(1) == 0);
}

TEST_CASE("unit stays below 1, at or above 0, and fills the range") {
  Random random(8);
  double least = 1, greatest = 0;
  for (int i = 0; i < 10000; ++i) {
    const double x = random.unit();
    REQUIRE(x >= 0);
    REQUIRE(x < 1);
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  }
  CHECK(least < 0.001);
  CHECK(greatest > 0.999);
}
