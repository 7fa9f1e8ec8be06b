// Each condition on impacts at one time accepts the outcome of the law, exactly, and is the one that a wrong outcome of
// its kind violates.
#include "reference/impact_conditions.h"

#include <cmath>
#include <vector>

#include "tests/catch.h"
#include "tests/reference/moving_scenes.h"

namespace touchstone::tests {
namespace {

using reference::condition_errors;
using reference::ImpactCondition;
using reference::ReportedImpacts;
using reference::violated;

constexpr double allowed = 0x1p-40;

/// A cube of half side 1 and mass 1 that falls flat on a table with speed 1, and leaves with e. Moment 1.
ReportedImpacts flat_cube(double e) {
  ReportedImpacts reported;
  reported.before.bodies = {body(Box{Vec3(1, 1, 1)}, Vec3(0, 0, 1)), body(Box{Vec3(8, 8, 1)}, Vec3(0, 0, -1))};
  for (Body& each : reported.before.bodies) each.material = {e, 0};
  reported.before.bodies[0].mass = round_mass();
  reported.before.bodies[0].velocity.v_WBcm.z() = -1;
  reported.before.bodies[1].mass = Fixed{};
  reported.regions = {{0, 1, Vec3(0, 0, 1), {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(-1, -1, 0), Vec3(-1, 1, 0)}}};
  reported.impulses = {{0, Vec3::Zero(), Vec3(0, 0, 1 + e)}};
  reported.after = {Velocity{Vec3(0, 0, e), Vec3::Zero()}, Velocity{}};
  return reported;
}

TEST_CASE("impact conditions: the outcome of the law, and each of the ways to break it") {
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double error : condition_errors(flat_cube(e))) CHECK(error == 0);
  }

  ReportedImpacts reported = flat_cube(0.5);
  reported.impulses[0].P_A_W.z() += 0x1p-30;
  CHECK(violated(reported, allowed) == ImpactCondition::momentum);
  CHECK(condition_errors(reported)[0] == Approx(0x1p-30 / std::sqrt(1.25 + 2.25)).epsilon(1e-6));

  reported = flat_cube(0.5);  // the table pulls at one side
  reported.impulses = {{0, Vec3::Zero(), Vec3(0, 0, 3.5)}, {0, Vec3::Zero(), Vec3(0, 0, -2)}};
  CHECK(violated(reported, allowed) == ImpactCondition::cone);
  CHECK(condition_errors(reported)[1] == 1);

  reported = flat_cube(0.5);
  reported.before.bodies[0].velocity.v_WBcm.x() = -1;
  reported.after[0].v_WBcm.x() = -1 + 0x1p-20;
  reported.impulses[0].P_A_W.x() = 0x1p-20;
  reported.after[0].w_WB.y() = -0x1p-20;
  CHECK(violated(reported, allowed) == ImpactCondition::cone);
  for (Body& each : reported.before.bodies) each.material.friction = 0x1p-20;
  CHECK(violated(reported, allowed) == std::nullopt);

  reported = flat_cube(0.5);  // it leaves with twice its speed: 4 times its energy
  reported.impulses[0].P_A_W.z() = 3;
  reported.after[0].v_WBcm.z() = 2;
  CHECK(violated(reported, allowed) == ImpactCondition::energy);
  CHECK(condition_errors(reported)[static_cast<std::size_t>(ImpactCondition::energy)] == 3);

  reported = flat_cube(1);  // beside the cube, by 1
  reported.impulses[0].point_W.x() = 2;
  reported.impulses[0].P_A_W.z() = 0.5;
  reported.after[0] = {Vec3(0, 0, -0.5), Vec3(0, -1, 0)};
  CHECK(violated(reported, allowed) == ImpactCondition::place);
  CHECK(condition_errors(reported)[2] == Approx(1 / std::sqrt(5.0 + 5.0)));
}

// The impulse of one corner, (1 + e)/3, alone: the opposite one still approaches, with 1 + (1 + e)/3.
TEST_CASE("impact conditions: one corner at a time leaves others that approach") {
  ReportedImpacts reported = flat_cube(1);
  reported.impulses = {{0, Vec3(1, 1, 0), Vec3(0, 0, 2.0 / 3)}};
  reported.after[0] = {Vec3(0, 0, -1.0 / 3), Vec3(2.0 / 3, -2.0 / 3, 0)};
  CHECK(violated(reported, allowed) == ImpactCondition::separation);
  const auto errors = condition_errors(reported);
  CHECK(errors[3] == Approx(5.0 / 3));  // of a speed of 1
  CHECK(errors[4] <= allowed);
}

// What one corner after the other leads to, until no corner approaches, in this order: contacts.md, row 1.
TEST_CASE("impact conditions: a spin that comes from an order obeys all but symmetry") {
  ReportedImpacts reported = flat_cube(1);
  reported.impulses = {{0, Vec3(0.25, 0, 0), Vec3(0, 0, 32.0 / 17)}};
  reported.after[0] = {Vec3(0, 0, 15.0 / 17), Vec3(0, -8.0 / 17, 0)};
  CHECK(violated(reported, allowed) == ImpactCondition::symmetry);
  CHECK(condition_errors(reported)[8] == Approx(2 * 8.0 / 17 * std::sqrt(3.0)));
}

TEST_CASE("impact conditions: energy") {
  ReportedImpacts reported = flat_cube(1);
  reported.impulses[0].P_A_W.z() = 2.5;
  reported.after[0].v_WBcm.z() = 1.5;
  CHECK(violated(reported, allowed) == ImpactCondition::energy);
  CHECK(condition_errors(reported)[4] == Approx(1.25));
  for (Body& each : reported.before.bodies) each.material.friction = 0.5;
  CHECK(condition_errors(reported)[4] == Approx(1.25));

  reported = flat_cube(1);  // e = 1 keeps it
  reported.impulses[0].P_A_W.z() = 1.5;
  reported.after[0].v_WBcm.z() = 0.5;
  CHECK(violated(reported, allowed) == ImpactCondition::elastic);
  CHECK(condition_errors(reported)[7] == Approx(0.75));

  // A cube that falls on its edge at y = 1 keeps the part of its motion that this edge does not stop.
  reported = flat_cube(0);
  reported.regions[0].points_W = {Vec3(1, 1, 0), Vec3(-1, 1, 0)};
  reported.impulses = {{0, Vec3(0, 1, 0), Vec3(0, 0, 0.5)}};
  reported.after[0] = {Vec3(0, 0, -0.5), Vec3(0.5, 0, 0)};
  CHECK(violated(reported, allowed) == std::nullopt);
  reported.impulses.push_back({0, Vec3(0, 1, 0), Vec3(0, 0, 0)});
  reported.after[0] = {Vec3::Zero(), Vec3::Zero()};
  CHECK(condition_errors(reported)[6] == Approx(0.5));  // and momentum is not kept
}

TEST_CASE("impact conditions: bodies of which none approaches keep their velocities") {
  ReportedImpacts reported = flat_cube(1);
  reported.before.bodies[0].velocity.v_WBcm.z() = 1;
  reported.impulses[0].P_A_W.z() = 1;
  reported.after[0].v_WBcm.z() = 2;
  CHECK(condition_errors(reported)[5] == Approx(1 / std::sqrt(5.0)));
  reported.impulses.clear();
  reported.after[0].v_WBcm.z() = 1;
  CHECK(violated(reported, allowed) == std::nullopt);
}

// Clamped between two walls, it cannot both keep its energy and not approach.
TEST_CASE("impact conditions: a clamped ball may stop") {
  ReportedImpacts reported;
  for (const double x : {0.0, 2.0, -2.0}) {
    reported.before.bodies.push_back(body(Sphere{1}, Vec3(x, 0, 0)));
    reported.before.bodies.back().mass = Fixed{};
    reported.before.bodies.back().material.restitution = 1;
  }
  reported.before.bodies[0].mass = round_mass();
  reported.before.bodies[0].velocity.v_WBcm.x() = 1;
  reported.regions = {{0, 1, Vec3(-1, 0, 0), {Vec3(1, 0, 0)}}, {0, 2, Vec3(1, 0, 0), {Vec3(-1, 0, 0)}}};
  reported.impulses = {{0, Vec3(1, 0, 0), Vec3(-1, 0, 0)}};
  reported.after.resize(3);
  CHECK(violated(reported, allowed) == std::nullopt);
}

}  // namespace
}  // namespace touchstone::tests
