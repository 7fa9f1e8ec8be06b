// One linear solve for contacts whose states are known.
#include "fast/contact/active_set.h"

#include "tests/catch.h"
#include "tests/fast/contact/rows.h"

namespace touchstone::fast::contact {
namespace {

/// With P as the guess: its effect is added to the twists, as solve_active_set expects.
Contacts guessed(Contacts contacts, const std::vector<Vec3>& guess) {
  for (std::size_t i = 0; i < guess.size(); ++i) {
    contacts.rows[i].P = guess[i];
    apply_impulse(contacts.rows[i], guess[i], contacts.bodies, contacts.twists);
  }
  return contacts;
}

Contacts solved(Contacts contacts) {
  solve_active_set(contacts.rows, contacts.bodies, contacts.twists);
  return contacts;
}

// The matrix has a condition of about 10⁶ to 10⁷, so impulses are right to 10⁻⁹; velocities are better.
TEST_CASE("active set: a tower of any masses is solved at once if all its contacts are known to press") {
  const Contacts done = solved(guessed(tower({1, 1, 1e6}), {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}));
  CHECK(done.rows[0].P.z() == Approx(1e6 + 2).epsilon(1e-9));
  CHECK(done.rows[1].P.z() == Approx(1e6 + 1).epsilon(1e-9));
  CHECK(done.rows[2].P.z() == Approx(1e6).epsilon(1e-9));
  for (const Twist& twist : done.twists) CHECK(twist.v.norm() < 1e-9);
}

TEST_CASE("active set: a contact without an impulse stays open") {
  const Contacts done = solved(guessed(tower({1, 2}), {Vec3(0, 0, 1), Vec3(0, 0, 0)}));
  CHECK(done.rows[0].P.z() == Approx(1));
  CHECK(done.rows[1].P == Vec3(0, 0, 0));
  CHECK(done.twists[1].v == Vec3(0, 0, -1));
}

TEST_CASE("active set: a contact inside of its cone stops to slip, one on the rim keeps the direction and the ratio") {
  const Contacts sticks = solved(guessed(ball_on_floor({7, 0, -8}, 0.5), {Vec3(0, 0, 1)}));
  CHECK((sticks.rows[0].P - Vec3(-4, 0, 16)).norm() < 1e-12);
  const Contacts slips = solved(guessed(ball_on_floor({7, 0, -8}, 0.125), {Vec3(-0.125, 0, 1)}));
  CHECK((slips.rows[0].P - Vec3(-2, 0, 16)).norm() < 1e-12);
}

// Each body is A of one contact and B of another, and no arm is parallel to a normal: so all four ways in which two
// contacts share a body count, with all of their terms.
TEST_CASE("active set: three bodies that press on each other in a ring stick at all contacts at once") {
  Contacts ring;
  ring.bodies = {{1, Vec3(1, 2, 3).asDiagonal()}, {0.5, Vec3(3, 1, 2).asDiagonal()}, {2, Vec3(0.5, 4, 1).asDiagonal()}};
  ring.twists = {{{1, -2, 0.5}, {0.25, 1, -1}}, {{-1, 0.5, 2}, {1, 0, 0.5}}, {{0.5, 1, -1}, {-0.5, 0.25, 2}}};
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0), std::pair(1, 0)}) {
    ContactRow row;
    row.a = a;
    row.b = b;
    row.n = Vec3(0, 0, 1);
    row.arm_A = Vec3(0.5 + a, -0.25, 0.75 - b);
    row.arm_B = Vec3(-0.5, 1 + b, 0.25 * a);
    row.friction = 8;
    prepare(row, ring.bodies);
    ring.rows.push_back(row);
  }
  const Contacts done = solved(guessed(ring, std::vector<Vec3>(4, Vec3(0.25, 0, 1))));
  for (const ContactRow& row : done.rows) CHECK(relative_velocity(row, done.twists).norm() < 1e-9);
}

TEST_CASE("active set: the lower bound of the normal velocity is reached") {
  Contacts contacts = guessed(ball_on_floor({0, 0, -3}, 0.5), {Vec3(0, 0, 1)});
  contacts.rows[0].least_u_n = -1;
  CHECK(solved(contacts).twists[0].v.z() == Approx(-1));
}

}  // namespace
}  // namespace touchstone::fast::contact
