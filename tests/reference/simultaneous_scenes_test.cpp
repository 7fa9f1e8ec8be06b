// Scenes whose outcome by the law of docs/design/simultaneous.md is a fraction, exactly. The fractions were computed
// from the law by a program of its own, which tries all sets of points that press, or by hand (rows 12, 19 and 21). A
// number in a name is the scene's row in the table of that page.
#include <algorithm>
#include <string>
#include <vector>

#include "reference/simultaneous.h"
#include "tests/catch.h"
#include "tests/reference/exact_text.h"
#include "tests/reference/moving_scenes.h"

namespace touchstone::tests {
namespace {

using reference::all_rounds;
using reference::AllRounds;
using reference::ContactRegion;
using reference::ExactVec3;

/// Bodies, and the regions at which they touch. Only masses, velocities, poses and materials of the bodies matter.
struct Impacts {
  Scene scene;
  std::vector<ContactRegion> regions = {};

  AllRounds resolved() const { return all_rounds(scene, regions).value(); }
};

using Corners = std::vector<std::pair<double, double>>;
const Corners four = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
const Corners nine = {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 0}, {0, 1}, {1, -1}, {1, 0}, {1, 1}};

/// Body 0 falls on fixed ones, each with its own region of points (x, y) and its own e; they are at z = 0.
Impacts on_floor(Body falling, const std::vector<std::pair<Corners, double>>& floors) {
  falling.material.restitution = 1;
  Impacts all;
  all.scene.bodies = {std::move(falling)};
  for (const auto& [corners, e] : floors) {
    Body& floor = all.scene.bodies.emplace_back(body(Box{Vec3(8, 8, 1)}, Vec3(0, 0, -1)));
    floor.mass = Fixed{};
    floor.material.restitution = e;
    ContactRegion& region =
        all.regions.emplace_back(ContactRegion{0, static_cast<int>(all.scene.bodies.size()) - 1, Vec3(0, 0, 1), {}});
    for (const auto& [x, y] : corners) region.points_W.emplace_back(x, y, 0);
  }
  return all;
}

/// A uniform box with these half sides: v_z, then ω_x, ω_y.
Body box(const Vec3& half, const Vec3& motion) {
  Body falling = body(Box{half}, Vec3(0, 0, half.z()));
  falling.velocity = {Vec3(0, 0, motion.x()), Vec3(motion.y(), motion.z(), 0)};
  return falling;
}

/// v_z, ω_x and ω_y of body 0, after one round.
std::string after_one(const Impacts& all) {
  const AllRounds done = all.resolved();
  CHECK(done.rounds == 1);
  CHECK_FALSE(done.completed);
  const reference::ExactVelocity& V = done.after[0];
  return V.v_WBcm[2].text() + ", " + V.w_WB[0].text() + ", " + V.w_WB[1].text();
}

TEST_CASE("simultaneous scenes 1 to 6: a cube or block on the points of its bottom") {
  const auto cube = [](double v, double w_x, const Corners& corners, double e) {
    return after_one(on_floor(box(Vec3(1, 1, 1), Vec3(v, w_x, 0)), {{corners, e}}));
  };
  for (const Corners& corners : {four, nine}) {
    CHECK(cube(-1, 0, corners, 0.5) == "1/2, 0, 0");
    CHECK(cube(-1, 0.25, corners, 0.5) == "1/2, -1/8, 0");
    CHECK(cube(-1, -1, corners, 0) == "0, 0, 0");
    CHECK(cube(-1, -1, corners, 0.5) == "1/2, 1/2, 0");
    CHECK(cube(-1, -1, corners, 1) == "1, 1, 0");
  }
  CHECK(cube(-1, 0, {{1, 0}, {-1, 0}}, 0.5) == "1/2, 0, 0");
  CHECK(cube(-1, 0, {{1, 1}, {-1, 1}}, 0.5) == "-2/5, 9/10, 0");
  const auto slender = [](double e) { return after_one(on_floor(box(Vec3(1, 1, 3), Vec3(-1, -1, 0)), {{four, e}})); };
  CHECK(slender(0) == "7/13, -7/13, 0");
  CHECK(slender(0.5) == "17/13, -4/13, 0");
  CHECK(slender(1) == "27/13, -1/13, 0");
}

TEST_CASE("simultaneous scene 1: in each order of the corners") {
  Corners corners = four;
  std::ranges::sort(corners);
  do {
    for (const double e : {0.0, 0.5, 1.0}) {
      const Impacts all = on_floor(box(Vec3(1, 1, 1), Vec3(-1, 0, 0)), {{corners, e}});
      CHECK(after_one(all) == (e == 0 ? "0, 0, 0" : e == 1 ? "1, 0, 0" : "1/2, 0, 0"));
    }
  } while (std::next_permutation(corners.begin(), corners.end()));
}

Impacts row_of_balls(const std::vector<double>& speeds, double e, const std::vector<double>& masses = {}) {
  Impacts all;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    Body& ball = all.scene.bodies.emplace_back(body(Sphere{1}, Vec3(2.0 * static_cast<double>(i), 0, 0)));
    ball.mass = round_mass(masses.empty() ? 1 : masses[i]);
    ball.material.restitution = e;
    ball.velocity.v_WBcm.x() = speeds[i];
    if (i == 0) continue;
    const int a = static_cast<int>(i);
    all.regions.push_back({a, a - 1, Vec3(1, 0, 0), {Vec3(2 * a - 1, 0, 0)}});
  }
  return all;
}

std::string speeds(const AllRounds& done) {
  std::string all;
  for (const reference::ExactVelocity& V : done.after) all += (all.empty() ? "" : " ") + V.v_WBcm[0].text();
  return all;
}

TEST_CASE("simultaneous scenes 7 to 9, 13 and 14: Newton's cradle") {
  const auto after = [](const std::vector<double>& v, double e, const std::vector<double>& masses = {}) {
    return speeds(row_of_balls(v, e, masses).resolved());
  };
  CHECK(after({1, 0, 0, 0, 0}, 1) == "0 0 0 0 1");
  CHECK(after({1, 1, 0, 0, 0}, 1) == "0 0 0 1 1");
  CHECK(after({1, 1, 1, 0, 0}, 1) == "0 0 1 1 1");
  CHECK(after({1, 0, 0, 0, -1}, 1) == "-1 0 0 0 1");
  CHECK(after({1, 0, 0}, 1, {1, 1, 2}) == "-1/3 0 2/3");
  CHECK(after({1, 0, -1}, 1) == "-1 0 1");
  const AllRounds half = row_of_balls({1, 0, 0}, 0.5).resolved();
  CHECK(speeds(half) == "13/64 15/64 9/16");
  CHECK(half.rounds == 3);
  CHECK_FALSE(half.completed);
  for (const double e : {0.0, 0.05}) {  // below 7 − 4√3 the first two hit each other infinitely often
    const AllRounds collapsed = row_of_balls({1, 0, 0}, e).resolved();
    CHECK(collapsed.completed);
    CHECK(speeds(collapsed) == "1/3 1/3 1/3");
  }
}

/// Disc 0 with velocity v onto 1 and 2, along these normals.
Impacts onto_two(const Vec3& v, const Vec3& to_1, const Vec3& to_2, double e) {
  Impacts all;
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(2 * to_1), Vec3(2 * to_2)}) {
    Body& disc = all.scene.bodies.emplace_back(body(Sphere{1}, place));
    disc.mass = round_mass();
    disc.material.restitution = e;
  }
  all.scene.bodies[0].velocity.v_WBcm = v;
  all.regions = {{1, 0, to_1, {to_1}}, {2, 0, to_2, {to_2}}};
  return all;
}

TEST_CASE("simultaneous scenes 10 and 11: a disc breaks two") {
  const auto after = [](double e) {
    const AllRounds done = onto_two(Vec3(1, 0, 0), Vec3(4, 3, 0), Vec3(4, -3, 0), e).resolved();
    CHECK(done.rounds == 1);
    return text(done.after[0].v_WBcm) + "; " + text(done.after[1].v_WBcm) + "; " + text(done.after[2].v_WBcm);
  };
  CHECK(after(1) == "-7/57, 0, 0; 32/57, 8/19, 0; 32/57, -8/19, 0");
  CHECK(after(0.5) == "3/19, 0, 0; 8/19, 6/19, 0; 8/19, -6/19, 0");
}

// Three discs of one size in touch have normals at ±30°, which are irrational in their own plane's axes, and rational
// in the plane of (1, 1, 0) and (1, 0, 1), at 60°. Along the middle between these, (2, 1, 1), the striker keeps −1/5;
// the others leave along the normals with p = 4/5 of cos 30° √6 / 2, (6/5, 6/5, 0): (3/5, √3/5) of √6.
TEST_CASE("simultaneous scene 12: a disc breaks two that are in touch") {
  Impacts all = onto_two(Vec3(2, 1, 1), Vec3(1, 1, 0), Vec3(1, 0, 1), 1);
  all.regions.push_back({1, 2, Vec3(0, 1, -1), {Vec3(2, 1, 1)}});
  const AllRounds done = all.resolved();
  CHECK(done.rounds == 1);
  CHECK(text(done.after[0].v_WBcm) == "-2/5, -1/5, -1/5");
  CHECK(text(done.after[1].v_WBcm) == "6/5, 6/5, 0");
  CHECK(text(done.after[2].v_WBcm) == "6/5, 0, 6/5");
}

AllRounds in_wedge(const Vec3& v, const Vec3& right, const Vec3& left, double e) {
  Impacts all;
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(-2 * right), Vec3(-2 * left)}) {
    all.scene.bodies.push_back(body(Sphere{1}, place));
    all.scene.bodies.back().material.restitution = e;
    all.scene.bodies.back().mass = Fixed{};
  }
  all.scene.bodies[0].mass = round_mass();
  all.scene.bodies[0].velocity.v_WBcm = v;
  all.regions = {{0, 1, right, {-right}}, {0, 2, left, {-left}}};
  return all.resolved();
}

TEST_CASE("simultaneous scenes 15, 16 and 20: a ball in a wedge, and clamped between two walls") {
  const Vec3 steep(4, 3, 0), steep_left(-4, 3, 0), flat(3, 4, 0), flat_left(-3, 4, 0);
  CHECK(text(in_wedge({1, -1, 0}, steep, steep_left, 1).after[0].v_WBcm) == "-191/625, 863/625, 0");
  CHECK(text(in_wedge({1, -1, 0}, steep, steep_left, 0.5).after[0].v_WBcm) == "-134/625, 1523/2500, 0");
  for (const double e : {0.0, 0.5, 1.0}) {
    const std::string upward = e == 0 ? "0, 0, 0" : e == 1 ? "0, 1, 0" : "0, 1/2, 0";
    CHECK(text(in_wedge({0, -1, 0}, steep, steep_left, e).after[0].v_WBcm) == upward);
    CHECK(text(in_wedge({0, -1, 0}, flat, flat_left, e).after[0].v_WBcm) == upward);
  }
  for (const double e : {0.5, 1.0}) {
    const AllRounds clamped = in_wedge({1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, e);
    CHECK(clamped.completed);
    CHECK(text(clamped.after[0].v_WBcm) == "0, 0, 0");
  }
}

/// A beam along y of moment 3 that falls on pillars: its speed and spin.
Impacts beam_on(const std::vector<std::pair<std::vector<double>, double>>& pillars) {
  std::vector<std::pair<Corners, double>> floors;
  for (const auto& [ends, e] : pillars) {
    Corners& corners = floors.emplace_back(Corners{}, e).first;
    for (const double y : ends) corners.emplace_back(0, y);
  }
  Body beam = box(Vec3(1, 3, 1), Vec3(-1, 0, 0));
  beam.mass = round_mass(1, 3);
  return on_floor(beam, floors);
}

TEST_CASE("simultaneous scenes 17 to 19: a beam on two pillars") {
  CHECK(after_one(beam_on({{{-3, -1}, 0.5}, {{1, 2}, 0.5}})) == "1/2, 0, 0");
  CHECK(after_one(beam_on({{{-1}, 0.5}, {{2}, 0.5}})) == "1/2, 0, 0");
  CHECK(after_one(beam_on({{{-1}, 1}, {{2}, 0}})) == "2/3, -2/9, 0");
  CHECK(after_one(beam_on({{{2}, 0}, {{-1}, 1}})) == "2/3, -2/9, 0");
  for (const std::vector<double>& left : {std::vector<double>{-3, -1}, {-1, -3}, {-1, -2, -3, -1}}) {
    for (const std::vector<double>& right : {std::vector<double>{1, 3}, {3, 1}, {2, 3, 1}}) {
      CHECK(after_one(beam_on({{left, 1}, {right, 0}})) == "1/2, -1/6, 0");
      CHECK(after_one(beam_on({{right, 0}, {left, 1}})) == "1/2, -1/6, 0");
    }
  }
}

// n·n' = −9/10 with e = 1 and 0: half of the energy of compression may return, and e p alone would return five times
// as much as there was, so s² = 1/10. s is rounded down to a multiple of 2⁻⁶⁴.
TEST_CASE("Restitution is limited where one region's return would compress the other") {
  // N = (±√19, 1): N·N' = −18 = −9/10 |N|². √19 is a double, off by 2⁻⁵³ of it.
  const double x = std::sqrt(19.0);
  Impacts all;
  for (const double e : {1.0, 1.0, 0.0}) {
    all.scene.bodies.push_back(body(Sphere{1}));
    all.scene.bodies.back().material.restitution = e;
    all.scene.bodies.back().mass = Fixed{};
  }
  all.scene.bodies[0].mass = round_mass();
  all.scene.bodies[0].velocity.v_WBcm = {0, -1, 0};
  all.regions = {{0, 1, Vec3(x, 1, 0), {Vec3::Zero()}}, {0, 2, Vec3(-x, 1, 0), {Vec3::Zero()}}};  // without levers
  const AllRounds done = all.resolved();
  CHECK(done.rounds == 2);
  // In round 1 each presses by p N with Σ p = 1, and the first returns s/2 N, with s² |N|²/4 = 5 s² where 2 w = 1/2 may
  // be. That makes the second approach with 9 s, and K = 20 there: in round 2 it presses by 9/20 s N.
  const double s = std::sqrt(0.1);
  CHECK(done.impulses[0].P_A_W[1].nearest() == Approx(0.5 + s / 2).epsilon(1e-14));
  CHECK(done.impulses[1].P_A_W[1].nearest() == Approx(0.5 + 0.45 * s).epsilon(1e-14));
}

// It slides on: P = (1 + e) (1, −μ), so v_x = 2 − 3/4, and no torque remains if C is μ times the half height ahead.
TEST_CASE("simultaneous scene 21: a square that lands flat and slides keeps flat") {
  for (const Corners& corners : {four, nine}) {
    Impacts all = on_floor(box(Vec3(1, 1, 1), Vec3(-1, 0, 0)), {{corners, 0.5}});
    for (Body& each : all.scene.bodies) each.material.friction = 0.5;
    all.scene.bodies[0].velocity.v_WBcm.x() = 2;
    const Vec3 centre = reference::sliding_centre(all.scene, all.regions[0]).value();
    CHECK(centre == Vec3(0.5, 0, 0));
    Scene pair = all.scene;
    pair.contact = Contact{centre, Vec3(0, 0, 1), Law::poisson, 0.5, 0.5};
    const reference::ImpulseTruth truth = reference::impulse(pair);
    CHECK(text(truth.after[0].v_WBcm) == "5/4, 0, 1/2");
    CHECK(text(truth.after[0].w_WB) == "0, 0, 0");
  }
}

}  // namespace
}  // namespace touchstone::tests
