#include "fast/motion/tumble_period.h"

#include <cmath>
#include <numbers>

#include "tests/catch.h"

namespace touchstone::fast::motion {
namespace {

// ω₁' = ω₂ ω₃ and so on for c = (0, −1, 1): ω₁ stays, and (ω₂, ω₃) goes round at the rate |ω₁|, so T = 2π/|ω₁|.
TEST_CASE("tumble period: a flat disc has one, whichever axis is its own") {
  const Vec3 c{0, -1, 1}, w{4, 2, 1};
  for (int k = 0; k < 3; ++k) {
    const auto turned = [k](const Vec3& v) { return Vec3(v[k % 3], v[(k + 1) % 3], v[(k + 2) % 3]); };
    const Period found = period(turned(c), 0, turned(w), 0);
    INFO("axis " << (3 - k) % 3 << ": " << found.length << " +- " << found.error);
    CHECK(found.error < 1e-13);
    CHECK(std::abs(found.length - std::numbers::pi / 2) <= found.error);
  }
}

}  // namespace
}  // namespace touchstone::fast::motion
