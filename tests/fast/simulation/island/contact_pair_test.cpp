// A box on a table: where it touches, how far apart the two are, and how fast its corners approach.
#include "fast/simulation/island/contact_pair.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/simulation/island/island_bodies.h"

namespace touchstone::fast::simulation {
namespace {

IslandBodies box_above_table(double gap, const Vec3& v = Vec3::Zero()) {
  Body box = brick({1, 2, 1}, {0, 0, 1 + gap}, {});
  box.velocity.v_WBcm = v;
  return {{box, table()}, Vec3::Zero()};
}

TEST_CASE("contact pair: a box that lies on a table touches it at four corners") {
  const IslandBodies bodies = box_above_table(0);
  ContactPair pair{0, 1};
  REQUIRE(update(pair, bodies[0], bodies[1], near, reach));
  CHECK(pair.nhat_BA_W.z() == Approx(1));
  REQUIRE(pair.contact_points.size() == 4);
  for (const contact::ContactPoint& point : pair.contact_points) {
    const ImpactCandidate at = candidate_at(pair, point, bodies[0], bodies[1]);
    CHECK(at.touch.gap == Approx(0).margin(1e-14));
    CHECK(std::abs(at.touch.p_WC.x()) == Approx(1));
    CHECK(std::abs(at.touch.p_WC.y()) == Approx(2));
    CHECK(at.touch.p_WC.z() == Approx(0).margin(1e-14));
  }
}

TEST_CASE("contact pair: between near and reach it has no contact points, beyond reach it is none") {
  const IslandBodies within = box_above_table(0.0625), beyond = box_above_table(0.25), on = box_above_table(0);
  ContactPair pair{0, 1};
  REQUIRE(update(pair, within[0], within[1], near, reach));
  CHECK(pair.contact_points.empty());
  CHECK_FALSE(update(pair, beyond[0], beyond[1], near, reach));
  REQUIRE(update(pair, on[0], on[1], near, reach));
  CHECK(pair.contact_points.size() == 4);
  REQUIRE(update(pair, within[0], within[1], near, reach));
  CHECK(pair.contact_points.empty());
}

TEST_CASE("contact pair: forces are kept as the next guess if the number of points is the same") {
  const IslandBodies bodies = box_above_table(0);
  ContactPair pair{0, 1};
  REQUIRE(update(pair, bodies[0], bodies[1], near, reach));
  pair.contact_points[2].F_A_W = {0, 0, 7};
  REQUIRE(update(pair, bodies[0], bodies[1], near, reach));
  CHECK(pair.contact_points[2].F_A_W == Vec3(0, 0, 7));
}

TEST_CASE("contact pair: approach speed and distance of a point midway between the two") {
  const IslandBodies bodies = box_above_table(0x1p-11, {3, 0, -2});
  ContactPair pair{0, 1};
  REQUIRE(update(pair, bodies[0], bodies[1], near, reach));
  const ImpactCandidate at = candidate_at(pair, pair.contact_points.front(), bodies[0], bodies[1]);
  CHECK(at.u_n == Approx(-2));
  CHECK(at.touch.gap == Approx(0x1p-11));
  CHECK(at.touch.p_WC.z() == Approx(0x1p-12));
}

// The upper box is tilted by t about its lower edge at x = d, the lower one has an edge at x = 0. Along z the two are 0
// apart, and along the normal of the tilted face −d sin t. The tie is 2⁻¹⁰ near = 2⁻²⁰.
TEST_CASE("contact pair: of two normals that separate nearly equally the last one stays, and with it the clearances") {
  const double t = 0x1p-8;
  const auto tilted = [&](double d) {
    const Vec3 along(std::cos(t), 0, std::sin(t)), up(-std::sin(t), 0, std::cos(t));
    Body box = brick({1, 1, 1}, Vec3(d, 0, 0) + along + up, {});
    box.X_WB.q_WB = {std::cos(t / 2), 0, -std::sin(t / 2), 0};
    return IslandBodies{{box, brick({1, 1, 1}, {1, 0, -1}, {})}, Vec3::Zero()};
  };
  ContactPair pair{0, 1};
  const auto above = [&](const IslandBodies& bodies) {
    std::vector<bool> all;
    for (const double clearance : clearances(pair, bodies[0], bodies[0].state(), bodies[1], bodies[1].state(), near))
      all.push_back(clearance > near);
    return all;
  };
  const IslandBodies inside = tilted(0x1p-6), tie = tilted(-0x1p-15), outside = tilted(-0x1p-9);
  REQUIRE(update(pair, inside[0], inside[1], near, reach));
  CHECK((pair.nhat_BA_W - Vec3(0, 0, 1)).norm() < 1e-12);
  const std::vector<bool> corners = above(inside);
  CHECK(above(tie) == corners);
  REQUIRE(update(pair, tie[0], tie[1], near, reach));
  CHECK((pair.nhat_BA_W - Vec3(0, 0, 1)).norm() < 1e-12);
  REQUIRE(update(pair, outside[0], outside[1], near, reach));
  CHECK((pair.nhat_BA_W - Vec3(-std::sin(t), 0, std::cos(t))).norm() < 1e-12);
}

TEST_CASE("contact pair: clearances are those of all corners of both, in the given states") {
  const IslandBodies bodies = box_above_table(0);
  ContactPair pair{0, 1};
  REQUIRE(update(pair, bodies[0], bodies[1], near, reach));
  State lifted = bodies[0].state();
  lifted.X_WB.p_WB.z() += 0.5;
  const std::vector<double> all = clearances(pair, bodies[0], lifted, bodies[1], bodies[1].state(), near);
  REQUIRE(all.size() == 16);
  CHECK(std::ranges::min(all) == Approx(0.5));
  CHECK(std::ranges::count_if(all, [](double c) { return std::abs(c - 0.5) < 1e-12; }) == 8);  // the facing corners
  CHECK(std::ranges::max(all) == Approx(2.5));  // the upper corners of the box, and the lower ones of the table
}

}  // namespace
}  // namespace touchstone::fast::simulation
