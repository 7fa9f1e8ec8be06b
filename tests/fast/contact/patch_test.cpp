// The contact region of boxes on a plate, and whether it supports a point.
#include "fast/contact/patch.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/contact/axes.h"
#include "tests/fast/contact/posed.h"

namespace touchstone::fast::contact {
namespace {

constexpr double within = 0x1p-20;
const Vec3 somewhere(7, 7, 7);

std::vector<Vec3> patch_of(const Posed& A, const Posed& B) {
  return patch(A.solid(), A.at(), B.solid(), B.at(), z, somewhere, within);
}

TEST_CASE("patch: a cube over the plate's side touches it in the common rectangle") {
  const Posed A(cube(), Vec3(4, 0, 2)), B(plate(), Vec3::Zero());
  const std::vector<Vec3> corners = patch_of(A, B);
  REQUIRE(corners.size() == 4);
  for (const Vec3& corner : {Vec3(3, -1, 1), Vec3(4, -1, 1), Vec3(4, 1, 1), Vec3(3, 1, 1)})
    CHECK(std::ranges::any_of(corners, [&](const Vec3& p) { return (p - corner).norm() < 1e-14; }));
  CHECK(supports(corners, z, {3.5, 0, 9}));
  CHECK(!supports(corners, z, {2.5, 0, 9}));
  CHECK(!supports(corners, z, {4.5, 0, 9}));
}

TEST_CASE("patch: an edge on a plate is a segment, which supports nothing") {
  const Posed A(cube(), (1 + std::sqrt(2.0)) * z, eighth_turn({1, 0, 0})), B(plate(), Vec3::Zero());
  const std::vector<Vec3> corners = patch_of(A, B);
  REQUIRE(corners.size() == 2);
  CHECK(std::abs(corners[0].x() - corners[1].x()) == Approx(2));
  CHECK(!supports(corners, z, {0, 0, 2}));
}

TEST_CASE("patch: where the region is a point, or the two do not touch, it is the given point") {
  const Posed across(cube(), Vec3::Zero(), eighth_turn({0, 1, 0}));
  const Posed A(cube(), 2 * std::sqrt(2.0) * z, eighth_turn({1, 0, 0})), far(cube(), 3 * z);
  CHECK(patch_of(A, across) == std::vector<Vec3>{somewhere});
  CHECK(patch_of(far, Posed(plate(), Vec3::Zero())) == std::vector<Vec3>{somewhere});
}

TEST_CASE("patch: a body on two blocks has the corners of both, and supports what is between them") {
  const Compound blocks{{{{Vec3(-2, 0, 0), {}}, Box{Vec3(0.5, 1, 1)}}, {{Vec3(2, 0, 0), {}}, Box{Vec3(0.5, 1, 1)}}}};
  const Posed A(blocks, 2 * z), B(plate(), Vec3::Zero());
  const std::vector<Vec3> corners = patch_of(A, B);
  CHECK(corners.size() == 8);
  CHECK(supports(corners, z, {0, 0, 5}));
  CHECK(supports(corners, z, {2.25, 0.75, 5}));
  CHECK(!supports(corners, z, {2.75, 0, 5}));
}

}  // namespace
}  // namespace touchstone::fast::contact
