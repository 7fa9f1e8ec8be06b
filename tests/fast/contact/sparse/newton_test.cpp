// Impulses of many contacts: the same as by sweeps where these converge, and where they do not.
#include "fast/contact/sparse/newton.h"

#include "tests/catch.h"
#include "tests/fast/contact/sparse/cubes.h"

namespace touchstone::fast::contact {
namespace {

constexpr double enough = 0x1p-36;

struct Solution {
  Contacts contacts;
  bool converged = false;
};

Solution solved(Contacts contacts) {
  const bool converged =
      solve_newton(contacts.rows, contacts.bodies, contacts.twists, {.enough = enough, .factorisations = 320});
  CHECK((greatest_residual(contacts) <= enough) == converged);
  return {contacts, converged};
}

bool is_near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 0x1p-30; }

// 1/m + r²/I = 7/4, see solver_test.cpp.
TEST_CASE("newton: one ball on a floor, falling, closing a gap, opening, sticking and slipping") {
  CHECK(is_near(solved(ball_on_floor({0, 0, -3}, 0)).contacts.rows[0].P, {0, 0, 6}));
  Contacts closing = ball_on_floor({0, 0, -3}, 0);
  closing.rows[0].least_u_n = -1;
  CHECK(is_near(solved(closing).contacts.rows[0].P, {0, 0, 4}));
  CHECK(solved(ball_on_floor({1, 0, 2}, 1)).contacts.rows[0].P.isZero(0));
  CHECK(is_near(solved(ball_on_floor({7, 0, -8}, 0.5)).contacts.rows[0].P, {-4, 0, 16}));
  CHECK(is_near(solved(ball_on_floor({4.2, 5.6, -8}, 0.125)).contacts.rows[0].P, {-1.2, -1.6, 16}));
}

TEST_CASE("newton: a moving floor takes along what sticks to it") {
  Contacts contacts = ball_on_floor({0, 0, -8}, 0.5);
  contacts.twists[1].v = Vec3(0, -7, 0);
  const Solution done = solved(contacts);
  CHECK(is_near(done.contacts.rows[0].P, {0, -4, 16}));
  CHECK(done.contacts.twists[1].v == Vec3(0, -7, 0));
}

TEST_CASE("newton: towers and stacks that land, with masses of 1 to 1,000") {
  CHECK(solved(tower({1, 2, 4})).contacts.rows[1].P.z() == Approx(6).epsilon(1e-9));
  CHECK(solved(tower({1, 1, 1000})).contacts.rows[0].P.z() == Approx(1002).epsilon(1e-9));
  for (const int count : {1, 10, 100}) {
    const Solution done = solved(leaning_stack(count, 0, {0, 0, -1}, 0.5));
    CHECK(done.converged);
    CHECK(greatest_speed(done.contacts.twists) < enough * count);
  }
}

// Friction μ g takes μ of the fall's velocity, and no cube slips on another.
TEST_CASE("newton: a stack that slides on the floor loses mu of the normal impulse") {
  Contacts sliding = leaning_stack(4, 0, {4, 0, -1}, 0.125);
  for (std::size_t i = 4; i < sliding.rows.size(); ++i) sliding.rows[i].friction = 1;
  const Solution done = solved(sliding);
  CHECK(done.converged);
  for (std::size_t i = 0; i < 4; ++i) CHECK(is_near(done.contacts.twists[i].v, {3.875, 0, 0}));
}

TEST_CASE("newton: cubes that slip in different directions are solved, from nothing and from a guess") {
  for (const int count : {3, 10, 30}) {
    Contacts contacts = leaning_stack(count, 0, {0, 0, -0.01}, 0.5);
    for (int i = 0; i < count; ++i)
      contacts.twists[index(i)].v += Vec3(0.01 * (i * 7 % 5 - 2), 0.01 * (i * 3 % 7 - 3), 0);
    Solution done = solved(contacts);
    CHECK(done.converged);
    Contacts guessed = contacts;
    for (std::size_t i = 0; i < guessed.rows.size(); ++i) guessed.rows[i].P = done.contacts.rows[i].P;
    guessed.twists[0].v.x() += 0x1p-20;
    CHECK(solved(guessed).converged);
  }
}

}  // namespace
}  // namespace touchstone::fast::contact
