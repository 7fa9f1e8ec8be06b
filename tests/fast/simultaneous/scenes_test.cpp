// Scenes whose outcome by the law of docs/design/simultaneous.md is a fraction. A number in a name is the scene's row
// in the table of that page, which has the fractions; tests/reference/simultaneous_scenes_test.cpp has them exactly.
#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/catch.h"
#include "tests/fast/simultaneous/impacts.h"

// Allowed, but for scenes with another bound: 2⁻⁴³ of the greatest speed. A round is a least-squares problem of m rows
// and n columns, m n ≤ 120 here, solved by orthogonal transformations: an error of about m n κ 2⁻⁵³ (Higham 2002,
// theorem 20.3), κ ≤ 4 for the points that press. Later rounds do not magnify it, since a round brings no two
// velocities farther apart in energy, and where there are many, each is less than half of the one before. So 2 · 120 ·
// 4 · 2⁻⁵³.
namespace touchstone::fast::simultaneous {
namespace {

TEST_CASE("simultaneous scenes 1 to 3: a cube that falls flat, however its points are listed") {
  for (const double e : {0.0, 0.5, 1.0}) {
    Corners corners = four;
    std::ranges::sort(corners);
    do {
      CHECK(is_near(cube_after(-1, 0, 0, corners, e), {e, 0, 0}));
    } while (std::ranges::next_permutation(corners).found);
    const Corners nine = {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 0}, {0, 1}, {1, -1}, {1, 0}, {1, 1}};
    CHECK(is_near(cube_after(-1, 0, 0, nine, e), {e, 0, 0}));
    CHECK(is_near(cube_after(-1, 0.25, 0, nine, e), {e, -0.25 * e, 0}));
    CHECK(is_near(cube_after(-1, 0.25, 0, four, e), {e, -0.25 * e, 0}));
    CHECK(is_near(cube_after(-1, 0, 0, {{1, 0}, {-1, 0}}, e), {e, 0, 0}));
  }
}

// The impulse acts at y = 1, with K = 1 + 3/2: p = (1 + e) 2/5.
TEST_CASE("simultaneous scene 4: a cube that falls on one edge") {
  CHECK(is_near(cube_after(-1, 0, 0, {{1, 1}, {-1, 1}}, 0.5), {-0.4, 0.9, 0}));
}

// A point about which it rotates does not approach, but carries: the region acts as a whole.
TEST_CASE("simultaneous scenes 5 and 6: a body that rocks from one edge to the other") {
  for (const double e : {0.0, 0.5, 1.0}) CHECK(is_near(cube_after(-1, -1, 0, four, e), {e, e, 0}));
  // 2 × 6, moment 10/3, and velocities 0 and −2 at the edges: the low edge alone presses, K = 1 + 3/10.
  const auto slender = [](double e) {
    const Impacts done = resolved(on_floor(0.3, -1, -1, 0, {{four, e}}));
    return Vec3(13 * done.twists[0].v.z(), 13 * done.twists[0].w.x(), 13 * done.twists[0].w.y());
  };
  CHECK(is_near(slender(0), {7, -7, 0}, 1e-12));
  CHECK(is_near(slender(0.5), {17, -4, 0}, 1e-12));
  CHECK(is_near(slender(1), {27, -1, 0}, 1e-12));
}

TEST_CASE("simultaneous scenes 7 to 9, 13 and 14: Newton's cradle") {
  CHECK(are_near(speeds(resolved(row_of_balls({1, 0, 0, 0, 0}, 1))), {0, 0, 0, 0, 1}));
  CHECK(are_near(speeds(resolved(row_of_balls({1, 1, 0, 0, 0}, 1))), {0, 0, 0, 1, 1}));
  CHECK(are_near(speeds(resolved(row_of_balls({1, 1, 1, 0, 0}, 1))), {0, 0, 1, 1, 1}));
  CHECK(are_near(speeds(resolved(row_of_balls({1, 0, 0, 0, -1}, 1))), {-1, 0, 0, 0, 1}));
  CHECK(are_near(speeds(resolved(row_of_balls({1, 0, 0}, 1, {1, 1, 2}))), {-1.0 / 3, 0, 2.0 / 3}));
  CHECK(are_near(speeds(resolved(row_of_balls({1, 0, -1}, 1))), {-1, 0, 1}));
  // The first two hit each other again and again.
  for (const double e : {0.0, 0.05})
    CHECK(are_near(speeds(resolved(row_of_balls({1, 0, 0}, e))), {1.0 / 3, 1.0 / 3, 1.0 / 3}));
  const Impacts half = resolved(row_of_balls({1, 0, 0}, 0.5));
  CHECK(are_near(speeds(half), {13.0 / 64, 15.0 / 64, 9.0 / 16}));
  CHECK(half.rounds == 3);
}

/// A disc (0) that moves along x onto two (1, 2), which may touch each other.
Impacts disc_onto_two(double cosine, double sine, double e, bool in_touch) {
  Impacts all;
  all.bodies = {3, Mobility{1, Mat3::Identity()}};
  all.twists = {{{1, 0, 0}, Vec3::Zero()}, {}, {}};
  const Vec3 up(cosine, sine, 0), down(cosine, -sine, 0), across(0, 1, 0);
  all.regions = {{e, {point(1, 0, up, -up, up)}}, {e, {point(2, 0, down, -down, down)}}};
  if (in_touch) all.regions.push_back({e, {point(1, 2, across, -across, across)}});
  return all;
}

TEST_CASE("simultaneous scenes 10 to 12: a disc breaks two symmetrically") {
  const auto after = [](double cosine, double sine, double e, bool in_touch, const Vec3& striker, const Vec3& first) {
    const Impacts done = resolved(disc_onto_two(cosine, sine, e, in_touch));
    CHECK(is_near(done.twists[0].v, striker));
    CHECK(is_near(done.twists[1].v, first));
    CHECK(is_near(done.twists[2].v, {first.x(), -first.y(), 0}));
    CHECK(done.rounds == 1);
  };
  after(0.8, 0.6, 1, false, {-7.0 / 57, 0, 0}, {32.0 / 57, 8.0 / 19, 0});
  after(0.8, 0.6, 0.5, false, {3.0 / 19, 0, 0}, {8.0 / 19, 6.0 / 19, 0});
  // Normals at ±30°: the two struck ones also touch, and part.
  after(std::sqrt(0.75), 0.5, 1, true, {-0.2, 0, 0}, {0.6, std::sqrt(3) / 5, 0});
}

TEST_CASE("simultaneous scenes 15, 16 and 20: a ball in a wedge, and clamped between two walls") {
  const auto after = [](const Vec3& v, double x, double y, double e) {
    return resolved(ball_in_wedge(v, x, y, e)).twists[0].v;
  };
  CHECK(is_near(after({1, -1, 0}, 0.8, 0.6, 1), Vec3(-191, 863, 0) / 625));
  CHECK(is_near(after({1, -1, 0}, 0.8, 0.6, 0.5), {-134.0 / 625, 1523.0 / 2500, 0}));
  for (const double e : {0.0, 0.5, 1.0}) {
    CHECK(is_near(after({0, -1, 0}, 0.8, 0.6, e), {0, e, 0}));
    CHECK(is_near(after({0, -1, 0}, 0.6, 0.8, e), {0, e, 0}));
  }
  // Clamped between two walls it stays: no law can keep its energy.
  for (const double e : {0.5, 1.0}) CHECK(after({1, 0, 0}, 1, 0, e).norm() < rounding);
  // A wedge of angle α turns the ball's path in at most ⌈π/α⌉ rounds.
  const double half = std::atan(1) / 15;  // α = π/30
  const Impacts narrow = resolved(ball_in_wedge({0.3, -1, 0}, std::cos(half), std::sin(half), 1));
  CHECK(narrow.rounds > 20);
  CHECK(narrow.rounds <= 30);
  CHECK(energy(narrow) == Approx(0.545).epsilon(1e-12));
}

/// A beam along y of moment 3 that falls on pillars; its speed and spin after.
Vec3 beam_after(const std::vector<std::pair<std::vector<double>, double>>& pillars) {
  std::vector<std::pair<Corners, double>> regions;
  for (const auto& [ends, e] : pillars) {
    Corners& corners = regions.emplace_back(Corners{}, e).first;
    for (const double y : ends) corners.emplace_back(0, y);
  }
  const Impacts done = resolved(on_floor(1.0 / 3, -1, 0, 0, regions));
  return {done.twists[0].v.z(), done.twists[0].w.x(), done.twists[0].w.y()};
}

TEST_CASE("simultaneous scene 17: a beam on two pillars") {
  CHECK(is_near(beam_after({{{-3, -1}, 0.5}, {{1, 2}, 0.5}}), {0.5, 0, 0}));
  CHECK(is_near(beam_after({{{-1}, 0.5}, {{2}, 0.5}}), {0.5, 0, 0}));
}

// v' = s q. Pillars of one point: p = (2/3, 1/3), q = (2/3, 0), and 4/9 + (4/9)/3 = 16/27 is below twice the energy
// that may return, 2/3. Pillars of a width: of all p without a torque, (1/2, 1/2) at −1 and 1 has the least energy.
// The weight of the condition that p has the effect of compression is 2²⁰, so the split is off by about 2⁻⁴⁰: 8 of
// that.
TEST_CASE("simultaneous scenes 18 and 19: pillars of different restitution") {
  CHECK(is_near(beam_after({{{-1}, 1}, {{2}, 0}}), {2.0 / 3, -2.0 / 9, 0}));
  for (const std::vector<double>& left : {std::vector<double>{-3, -1}, {-1, -3}, {-1, -2, -3, -1}}) {
    for (const std::vector<double>& right : {std::vector<double>{1, 3}, {3, 1}, {2, 3, 1}}) {
      CHECK(is_near(beam_after({{left, 1}, {right, 0}}), {0.5, -1.0 / 6, 0}, 0x1p-37));
      CHECK(is_near(beam_after({{right, 0}, {left, 1}}), {0.5, -1.0 / 6, 0}, 0x1p-37));
    }
  }
}

// Friction of a round ends at changes of 2⁻⁴⁴ of the greatest, after which the geometric rest of the sweeps is left.
TEST_CASE("simultaneous scene 21: a square that lands flat and slides keeps flat") {
  Impacts all = on_floor(1.5, -1, 0, 0, {{four, 0.5}}, 1, 0.5);
  all.twists[0].v.x() = 2;
  const Impacts done = resolved(all);
  CHECK(is_near(done.twists[0].v, {1.25, 0, 0.5}, 1e-11));
  CHECK(done.twists[0].w.norm() < 1e-11);
}

}  // namespace
}  // namespace touchstone::fast::simultaneous
