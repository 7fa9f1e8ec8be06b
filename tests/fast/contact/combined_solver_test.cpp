// A tall tower, which sweeps do not solve.
#include "fast/contact/combined_solver.h"

#include "tests/catch.h"
#include "tests/fast/contact/rows.h"

namespace touchstone::fast::contact {
namespace {

TEST_CASE(
    "combined solver: each contact of a tower carries all that is above it, where sweeps alone do not get there") {
  const SolverLimits limits{.most_active_set_contacts = 0};
  const Contacts start = tower(std::vector<double>(100, 1.0));
  Contacts swept = start, done = start;
  CHECK_FALSE(solve(swept.rows, swept.bodies, swept.twists, limits));
  CHECK(greatest_residual(swept) > 1e-6);
  solve_combined(done.rows, done.bodies, done.twists, limits);
  CHECK(greatest_residual(done) < 1e-9);
  for (std::size_t i = 0; i < done.rows.size(); ++i)
    CHECK(done.rows[i].P.z() == Approx(100 - static_cast<double>(i)).epsilon(1e-9));
}

TEST_CASE("combined solver: what sweeps solve is theirs, bit for bit") {
  Contacts swept = tower({1, 2, 4}), done = swept;
  REQUIRE(solve(swept.rows, swept.bodies, swept.twists, {.is_patient = false}));
  solve_combined(done.rows, done.bodies, done.twists, {});
  for (std::size_t i = 0; i < done.rows.size(); ++i) CHECK(done.rows[i].P == swept.rows[i].P);
}

}  // namespace
}  // namespace touchstone::fast::contact
