// Friction at given normal impulses: the conditions of its minimum.
#include "fast/simultaneous/friction.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "fast/mark.h"
#include "tests/catch.h"
#include "tests/fast/simultaneous/impacts.h"

namespace touchstone::fast::simultaneous {
namespace {

/// A box that slides and spins on up to four points of a table, with normal impulses.
struct Sliding {
  explicit Sliding(unsigned seed) : generator(seed) {
    const double x = number(), y = number(), spin = number();
    impacts.bodies = {{1, Vec3(1, 2, 3).asDiagonal()}, {}};
    impacts.twists = {{Vec3(x, y, 0), Vec3(0, 0, spin)}, {}};
    const auto count = 1 + generator() % 4;
    for (std::size_t k = 0; k < count; ++k) {
      const double arm_x = number(), arm_y = number();
      ContactRow& row = points.emplace_back(point(0, 1, {0, 0, 1}, {arm_x, arm_y, -0.5}));
      row.friction = number() + 1;
      row.P = (number() + 1) / 8 * Vec3::UnitZ();
      prepare(row, impacts.bodies);
      apply_impulse(row, row.P, impacts.bodies, impacts.twists);
    }
  }
  double number() { return static_cast<double>(generator()) * 0x1p-31 - 1; }

  std::mt19937 generator;
  Impacts impacts;
  std::vector<ContactRow> points;
};

TEST_CASE("friction: it stops slip, or is opposite to the slip that is left and as great as Coulomb's law allows") {
  int cut_off = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    INFO("seed " << seed);
    Sliding drawn(seed);
    const auto& bodies = drawn.impacts.bodies;
    std::vector<Twist> twists = drawn.impacts.twists;
    const double before = energy(drawn.impacts);
    double fastest = 0;
    for (const ContactRow& row : drawn.points)
      fastest = std::max(fastest, relative_velocity(row, twists).norm() + row.K_tt * row.friction * row.P.norm());
    const MarkCounts marks = mark_counts;
    add_friction(drawn.points, bodies, twists);
    const bool has_converged = marks_since(marks)[static_cast<std::size_t>(Mark::friction_step)] < 400;
    cut_off += has_converged ? 0 : 1;
    // The last step is at most 2⁻⁴⁴ of the greatest velocity. Times the number of points it is the slip before that
    // step, and also what the step changes. On the rim of the disc slip counts twice.
    const double rest = 4 * static_cast<double>(drawn.points.size()) * 0x1p-44 * fastest;
    Impacts after = drawn.impacts;
    after.twists = twists;
    CHECK(energy(after) <= before * (1 + 1e-12));
    for (const ContactRow& row : drawn.points) {
      const Vec3 u = relative_velocity(row, twists), slip = u - row.n.dot(u) * row.n;
      const Vec3 P_t = friction_of(row);
      const double most = row.friction * row.n.dot(row.P);
      CHECK(P_t.norm() <= most * (1 + 1e-12));
      // Inside of the disc nothing slips; on the rim P_t is opposite to the slip.
      if (has_converged) CHECK(slip.norm() * most + slip.dot(P_t) <= rest * most);
    }
  }
  CHECK(cut_off <= 10);  // points may be close to each other
}

}  // namespace
}  // namespace touchstone::fast::simultaneous
