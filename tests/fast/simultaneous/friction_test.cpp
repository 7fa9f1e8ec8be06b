// Friction at the centres of pressure of several regions: the conditions of its minimum, and its distribution.
#include "fast/simultaneous/friction.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/catch.h"
#include "tests/fast/simultaneous/impacts.h"

namespace touchstone::fast::simultaneous {
namespace {

/// A box that slides and spins on up to six regions of a table, with normal impulses.
struct Sliding {
  explicit Sliding(unsigned seed) : generator(seed) {
    impacts.bodies = {{1, Vec3(1, 2, 3).asDiagonal()}, {}};
    impacts.twists = {{Vec3(number(), number(), 0), Vec3(0, 0, number())}, {}};
    const auto count = 1 + generator() % 6;
    for (std::size_t r = 0; r < count; ++r) {
      Region& region = impacts.regions.emplace_back();
      const double friction = number() + 1;
      for (std::size_t k = 0; k < 1 + r % 3; ++k) {
        region.points.push_back(point(0, 1, {0, 0, 1}, {number(), number(), -0.5}, {number(), number(), 0}));
        region.points.back().friction = friction;
        region.points.back().P = (number() + 1) / 8 * Vec3::UnitZ();
        points.push_back(region.points.back());
      }
    }
    for (ContactRow& row : points) {
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
  for (unsigned seed = 0; seed < 200; ++seed) {
    INFO("seed " << seed);
    Sliding drawn(seed);
    const auto& bodies = drawn.impacts.bodies;
    std::vector<Twist> twists = drawn.impacts.twists;
    std::vector<ContactRow> centres = centres_of_pressure(drawn.impacts.regions, drawn.points, bodies);
    const double before = energy(drawn.impacts);
    double fastest = 0;
    for (const ContactRow& row : centres)
      fastest = std::max(fastest, relative_velocity(row, twists).norm() + row.K_tt * row.friction * row.P.norm());
    add_friction(centres, bodies, twists);
    // A last step of at most 2⁻⁴⁴ of the greatest velocity is that much times the number of centres in slip, on the rim
    // of the disc twice.
    const double rest = 2 * static_cast<double>(centres.size()) * 0x1p-44 * fastest;
    Impacts after = drawn.impacts;
    after.twists = twists;
    CHECK(energy(after) <= before * (1 + 1e-12));
    for (const ContactRow& centre : centres) {
      const Vec3 u = relative_velocity(centre, twists), slip = u - centre.n.dot(u) * centre.n;
      const Vec3 P_t = friction_of(centre);
      const double most = centre.friction * centre.n.dot(centre.P);
      CHECK(P_t.norm() <= most * (1 + 1e-12));
      // Inside of the disc nothing slips; on the rim P_t is opposite to the slip.
      CHECK(slip.norm() * most + slip.dot(P_t) <= rest * most);
    }
  }
}

TEST_CASE("friction: shared over the points it has the effect that it has at the centre") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    INFO("seed " << seed);
    Sliding drawn(seed);
    const auto& bodies = drawn.impacts.bodies;
    std::vector<Twist> at_centres = drawn.impacts.twists, at_points = drawn.impacts.twists;
    std::vector<ContactRow> centres = centres_of_pressure(drawn.impacts.regions, drawn.points, bodies);
    add_friction(centres, bodies, at_centres);
    share_friction(drawn.impacts.regions, centres, drawn.points);
    for (const ContactRow& row : drawn.points) {
      CHECK(friction_of(row).norm() <= row.friction * row.n.dot(row.P) * (1 + 1e-12));
      apply_impulse(row, friction_of(row), bodies, at_points);
    }
    CHECK(is_near(at_points[0].v, at_centres[0].v, 1e-13));
    CHECK(is_near(at_points[0].w, at_centres[0].w, 1e-13));
  }
}

}  // namespace
}  // namespace touchstone::fast::simultaneous
