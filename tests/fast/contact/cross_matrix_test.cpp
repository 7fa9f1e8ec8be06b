// r× as a matrix.
#include "fast/contact/cross_matrix.h"

#include "tests/catch.h"

namespace touchstone::fast::contact {
namespace {

TEST_CASE("cross matrix: its product with a vector is the cross product") {
  CHECK(cross_matrix(Vec3(1, 0, 0)) * Vec3(0, 1, 0) == Vec3(0, 0, 1));
  CHECK(cross_matrix(Vec3(1, 2, 3)) * Vec3(4, 5, 6) == Vec3(-3, 6, -3));
}

TEST_CASE("cross matrix: it is antisymmetric") {
  const Mat3 M = cross_matrix(Vec3(1, 2, 3));
  CHECK(M.transpose() == -M);
}

}  // namespace
}  // namespace touchstone::fast::contact
