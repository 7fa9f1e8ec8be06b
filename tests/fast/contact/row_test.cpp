// What an impulse at a contact does to two bodies, for bodies whose response is known.
#include "fast/contact/row.h"

#include "tests/catch.h"
#include "tests/fast/contact/axes.h"

namespace touchstone::fast::contact {
namespace {

/// A body of mass 2 with the moments of inertia 1, 1/2 and 1/4, above a fixed one; the contact is 1 below its centre.
const std::vector<Mobility> bodies = {{0.5, Vec3(1, 2, 4).asDiagonal()}, {}};

ContactRow row_below() {
  ContactRow row;
  row.b = 1;
  row.n = z;
  row.arm_A = -z;
  prepare(row, bodies);
  return row;
}

TEST_CASE("row: K along the normal is 1/m, across it, a turn about y adds r²/I, and the greater eigenvalue counts") {
  const ContactRow row = row_below();
  CHECK(row.K_nn == Approx(0.5));
  CHECK(row.K_tt == Approx(0.5 + 2));  // an impulse along x turns about y, with 1/I = 2; along y it would be 1/2 + 1
}

TEST_CASE("row: an impulse changes the velocity at the contact by K P, on both bodies with opposite signs") {
  const ContactRow row = row_below();
  std::vector<Twist> twists(2);
  apply_impulse(row, 3 * z, bodies, twists);
  CHECK(twists[0].v == Vec3(0, 0, 1.5));
  CHECK(twists[0].w == Vec3(0, 0, 0));
  CHECK(relative_velocity(row, twists) == Vec3(0, 0, 1.5));
  CHECK(row.K_n == Vec3(0, 0, 0.5));
  apply_impulse(row, x, bodies, twists);
  CHECK(twists[0].w == Vec3(0, -2, 0));
  CHECK(relative_velocity(row, twists) == Vec3(2.5, 0, 1.5));
  CHECK(twists[1].v == Vec3(0, 0, 0));  // fixed

  const std::vector<Mobility> two = {{0.5, Mat3::Zero()}, {0.25, Mat3::Zero()}};
  std::vector<Twist> apart(2);
  apply_impulse(row, 4 * z, two, apart);
  CHECK(apart[0].v == Vec3(0, 0, 2));
  CHECK(apart[1].v == Vec3(0, 0, -1));
  CHECK(relative_velocity(row, apart) == Vec3(0, 0, 3));
}

TEST_CASE("row: a contact sticks inside of its friction disc, on the rim it slips") {
  ContactRow row = row_below();
  row.P = 2 * z + x;
  row.friction = 0.5;
  CHECK(!sticks(row));
  row.friction = 0.75;
  CHECK(sticks(row));
  row.P.setZero();
  CHECK(!sticks(row));
}

}  // namespace
}  // namespace touchstone::fast::contact
