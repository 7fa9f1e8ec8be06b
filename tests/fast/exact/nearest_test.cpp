// The exact route alone, from bad guesses too, against the reference's exact distance.
#include "fast/exact/nearest.h"

#include <cmath>

#include "reference/distance.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::exact {
namespace {

using tests::Dice;

std::vector<Vec3> vertices(const Shape& shape) {
  if (const auto* polytope = std::get_if<Polytope>(&shape)) return polytope->vertices;
  std::vector<Vec3> corners{Vec3::Zero()};
  if (const auto* box = std::get_if<Box>(&shape)) {
    corners.clear();
    for (int i = 0; i < 8; ++i) {
      corners.push_back(box->half_extents.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    }
  }
  return corners;
}

/// |d*|², rounded.
double squared(const Nearest& found, const Difference& difference) {
  const Dyadic over = found.squared_over * difference.denominator() * difference.denominator();
  const Dyadic::Scientific x = found.squared_times.scientific();
  const Dyadic::Scientific y = over.scientific();
  return std::ldexp(x.m / y.m, static_cast<int>(x.exponent - y.exponent));
}

TEST_CASE("the exact route agrees with the reference, whatever pair it starts from") {
  Dice dice(11);
  int separated = 0;
  int touching = 0;
  int overlapping = 0;
  for (int i = 0; i < 12 * tests::hard_families; ++i) {
    const Scene scene = tests::hard_pair(i % tests::hard_families, dice);
    if (scene.bodies[0].shape.index() == 3 || scene.bodies[1].shape.index() == 3) continue;
    const reference::DistanceTruth truth = reference::distance(scene);
    const std::vector<Vec3> A = vertices(scene.bodies[0].shape);
    const std::vector<Vec3> B = vertices(scene.bodies[1].shape);
    const Pose poses[] = {scene.bodies[0].X_WB, scene.bodies[1].X_WB};
    for (int start = 0; start < 3; ++start) {
      Difference difference({std::span(poses).first(1), A}, {std::span(poses).last(1), B});
      const VertexPair guess{dice.between(0, static_cast<int>(A.size()) - 1),
                             dice.between(0, static_cast<int>(B.size()) - 1)};
      const Nearest found = nearest(difference, {guess});
      CHECK(found.verdict == truth.certificate.cores);
      const double expected = truth.core_squared.nearest();
      if (found.verdict == Verdict::separated) {
        CHECK(std::abs(squared(found, difference) - expected) <= 0x1p-48 * expected);
      } else {
        CHECK(truth.core_squared.sign() == 0);
      }
      separated += found.verdict == Verdict::separated;
      touching += found.verdict == Verdict::touching;
      overlapping += found.verdict == Verdict::overlapping;
    }
  }
  CHECK(separated > 50);
  CHECK(touching > 20);
  CHECK(overlapping > 50);
}

}  // namespace
}  // namespace touchstone::fast::exact
