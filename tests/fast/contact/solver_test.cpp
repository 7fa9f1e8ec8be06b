// Impulses at one and at several contacts, as computed on paper, and the residual.
#include "fast/contact/solver.h"

#include "tests/catch.h"
#include "tests/fast/contact/rows.h"

namespace touchstone::fast::contact {
namespace {

bool is_near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-12; }

Contacts solved(Contacts contacts, const SolverLimits& limits = {}) {
  solve(contacts.rows, contacts.bodies, contacts.twists, limits);
  return contacts;
}

TEST_CASE("solver: a ball that falls at 3 m/s needs an impulse of 2 kg times 3 m/s") {
  const Contacts done = solved(ball_on_floor({0, 0, -3}, 0));
  CHECK(is_near(done.rows[0].P, {0, 0, 6}));
  CHECK(done.twists[0].v.norm() < 1e-12);
}

TEST_CASE("solver: it may close a gap, and a contact that opens gets no impulse") {
  Contacts closing = ball_on_floor({0, 0, -3}, 0);
  closing.rows[0].least_u_n = -1;
  CHECK(is_near(solved(closing).rows[0].P, {0, 0, 4}));
  CHECK(is_near(solved(ball_on_floor({1, 0, 2}, 1)).rows[0].P, {0, 0, 0}));
}

// Slip stops at an impulse of 2/7 m u_t: (1/m + r²/I) P = (1/2 + 5/4) P = u_t.
TEST_CASE("solver: friction stops a ball's slip if the cone allows it, and otherwise acts with mu P_n against it") {
  const Contacts sticks = solved(ball_on_floor({7, 0, -8}, 0.5));
  CHECK(is_near(sticks.rows[0].P, {-4, 0, 16}));
  CHECK(is_near(sticks.twists[0].v, {5, 0, 0}));
  CHECK(is_near(sticks.twists[0].w, {0, 5, 0}));
  const Contacts slips = solved(ball_on_floor({4.2, 5.6, -8}, 0.125));  // slip of 7 along (3, 4)/5
  CHECK(is_near(slips.rows[0].P, {-1.2, -1.6, 16}));
}

TEST_CASE("solver: each contact of a tower carries all that is above it") {
  const Contacts done = solved(tower({1, 2, 4}));
  CHECK(done.rows[0].P.z() == Approx(7));
  CHECK(done.rows[1].P.z() == Approx(6));
  CHECK(done.rows[2].P.z() == Approx(4));
  for (const Twist& twist : done.twists) CHECK(twist.v.norm() < 1e-12);
}

TEST_CASE("solver: a tower with a millionfold mass on top is solved through its active set") {
  const Contacts done = solved(tower({1, 1, 1e6}));
  CHECK(done.rows[0].P.z() == Approx(1e6 + 2).epsilon(1e-12));
  CHECK(greatest_residual(done) < 1e-9);
  SolverLimits sweeps_alone;
  sweeps_alone.most_active_set_contacts = 0;
  CHECK(greatest_residual(solved(tower({1, 1, 1e6}), sweeps_alone)) > 1e-9);
}

TEST_CASE("solver: sweeps that are not patient end early where they converge slowly, and only there") {
  SolverLimits limits;
  limits.most_active_set_contacts = 0;
  for (const bool is_patient : {true, false}) {
    limits.is_patient = is_patient;
    limits.sweeps = 10000;
    Contacts short_tower = tower({1, 2, 4}), heavy = tower({1, 1, 1e6});
    CHECK(solve(short_tower.rows, short_tower.bodies, short_tower.twists, limits));
    limits.sweeps = 400;
    CHECK_FALSE(solve(heavy.rows, heavy.bodies, heavy.twists, limits));
    const Contacts longer = solved(tower({1, 1, 1e6}), limits);
    limits.sweeps = 64;
    const Contacts shorter = solved(tower({1, 1, 1e6}), limits);
    CHECK((longer.rows[0].P == shorter.rows[0].P) == !is_patient);
  }
}

TEST_CASE("solver: the guess does not change the result") {
  Contacts guessed = tower({1, 2, 4});
  for (ContactRow& row : guessed.rows) row.P = Vec3(1, -2, 5);
  CHECK(solved(guessed).rows[1].P.z() == Approx(6));
}

TEST_CASE("residual: 0 where the conditions hold, and else the velocity that is wrong") {
  const auto of = [](const Contacts& contacts) { return greatest_residual(contacts); };
  CHECK(of(solved(ball_on_floor({7, 0, -8}, 0.5))) < 1e-12);
  CHECK(of(solved(ball_on_floor({4.2, 5.6, -8}, 0.125))) < 1e-12);
  CHECK(of(ball_on_floor({1, 0, 2}, 1)) == 0);   // open: no impulse is right
  CHECK(of(ball_on_floor({0, 0, -3}, 0)) == 3);  // it goes on falling at 3 m/s
  Contacts pulls = ball_on_floor({0, 0, 2}, 0);  // an impulse although it opens at 2 m/s
  pulls.rows[0].P = Vec3(0, 0, 6);               // which makes 3 m/s
  CHECK(of(pulls) == 2);
  Contacts slides = ball_on_floor({7, 0, 0}, 0.5);  // it presses, but friction does not act
  slides.rows[0].P = Vec3(0, 0, 16);
  CHECK(of(slides) == Approx(7));
  Contacts beyond = ball_on_floor(Vec3::Zero(), 0.5);  // friction of 4 where 2 is allowed
  beyond.rows[0].P = Vec3(4, 0, 4);
  CHECK(of(beyond) == Approx(1.75 * 2));
}

TEST_CASE("residual: a solver that is stopped early has one, and it falls with every doubling of the sweeps") {
  double before = 9;
  for (const int sweeps : {1, 2, 4, 8}) {
    SolverLimits limits;
    limits.sweeps = sweeps;
    const double left = greatest_residual(solved(tower({1, 2, 4, 8}), limits));
    CHECK(left > 1e-6);
    CHECK(left < before);
    before = left;
  }
  CHECK(greatest_residual(solved(tower({1, 2, 4, 8}))) < 1e-12);
}

}  // namespace
}  // namespace touchstone::fast::contact
