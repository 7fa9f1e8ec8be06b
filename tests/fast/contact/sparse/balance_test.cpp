// What stands and what falls, on both sides of limits that statics gives.
#include "fast/contact/sparse/balance.h"

#include "tests/catch.h"
#include "tests/fast/contact/sparse/cubes.h"

namespace touchstone::fast::contact {
namespace {

constexpr double gravity = 10;

bool stands(Contacts contacts) {
  const double load = greatest_speed(contacts.twists);
  balance(contacts.rows, contacts.bodies, contacts.twists);
  for (const ContactRow& row : contacts.rows) {
    const double P_n = row.n.dot(row.P);
    CHECK((row.P - P_n * row.n).norm() <= row.friction * P_n + 0x1p-50 * row.P.norm());  // the rounding of this line
  }
  return greatest_speed(contacts.twists) <= 0x1p-30 * load;
}

/// A cube's load along x, relative to its weight.
Vec3 tilted(double slope) { return gravity * Vec3(slope, 0, -1); }

TEST_CASE("balance: a stack stands, and each face carries what is above it") {
  for (const int count : {1, 17, 200, 500}) {
    CHECK(stands(leaning_stack(count, 0, tilted(0), 0.5)));
    CHECK(stands(leaning_stack(count, 0, tilted(0), 0)));
  }
  Contacts contacts = leaning_stack(100, 0, tilted(0), 0.5);
  balance(contacts.rows, contacts.bodies, contacts.twists);
  for (int i = 0; i < 100; ++i) {
    double carried = 0;
    for (int corner = 0; corner < 4; ++corner) carried += contacts.rows[index(4 * i + corner)].P.z();
    CHECK(carried == Approx(gravity * (100 - i)).epsilon(1e-9));
  }
}

// The centre of the k cubes above a face lies (k + 1)/2 steps beyond the centre of the cube that they lie on. That may
// be 1/2, and k is at most n - 1: the limit is 1/n.
TEST_CASE("balance: a leaning stack of n cubes stands up to a step of 1/n") {
  CHECK(stands(leaning_stack(3, 0.3333, tilted(0), 0.5)));
  CHECK_FALSE(stands(leaning_stack(3, 0.3334, tilted(0), 0.5)));
  CHECK(stands(leaning_stack(10, 0.0999, tilted(0), 0.5)));
  CHECK_FALSE(stands(leaning_stack(10, 0.1001, tilted(0), 0.5)));
  CHECK(stands(leaning_stack(50, 0.0199, tilted(0), 0.5)));
  CHECK_FALSE(stands(leaning_stack(50, 0.0201, tilted(0), 0.5)));
}

TEST_CASE("balance: a cube holds on a ramp up to tan = mu") {
  CHECK(stands(leaning_stack(1, 0, tilted(0.499999), 0.5)));
  CHECK_FALSE(stands(leaning_stack(1, 0, tilted(0.500001), 0.5)));
}

// The centre of n cubes is n/2 high, so the load's line leaves the base beyond a slope of 1/n.
TEST_CASE("balance: a stack of n cubes tips beyond a slope of 1/n") {
  CHECK(stands(leaning_stack(50, 0, tilted(0.0196), 0.5)));
  CHECK_FALSE(stands(leaning_stack(50, 0, tilted(0.0204), 0.5)));
}

TEST_CASE("balance: what nothing carries keeps its load") {
  Contacts contacts = leaning_stack(2, 0, tilted(0), 0.5);
  contacts.rows.clear();
  CHECK_FALSE(stands(contacts));
  Contacts unloaded = leaning_stack(2, 0, Vec3::Zero(), 0.5);
  CHECK(stands(unloaded));
}

}  // namespace
}  // namespace touchstone::fast::contact
