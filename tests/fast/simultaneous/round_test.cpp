// Impacts at several points at one instant, against outcomes that were computed in fractions on paper, and against the
// laws that every outcome must obey on drawn scenes.
#include "fast/simultaneous/round.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "tests/catch.h"

namespace touchstone::fast::simultaneous {
namespace {

using contact::ContactRow;
using contact::Mobility;
using contact::Twist;

/// Bodies and the regions at which they touch.
struct Impacts {
  std::vector<Mobility> bodies;
  std::vector<Twist> twists;
  std::vector<Region> regions;
  int rounds = 0;
};

ContactRow point(int a, int b, const Vec3& n, const Vec3& arm_A, const Vec3& arm_B = Vec3::Zero()) {
  ContactRow row;
  row.a = a;
  row.b = b;
  row.n = n;
  row.arm_A = arm_A;
  row.arm_B = arm_B;
  return row;
}

/// The rounds of the law: all components of the regions that approach act, until none approaches. An approach that
/// rounding leaves does not count. After too many rounds, their limit: all regions act without restitution.
Impacts resolved(Impacts all, int most_rounds = 64) {
  double fastest = 0;
  for (const Twist& twist : all.twists) fastest = std::max({fastest, twist.v.norm(), twist.w.norm()});
  while (all.rounds < most_rounds) {
    std::vector<Region> approaching;
    for (const Region& region : all.regions) {
      if (least_normal_velocity(region, all.twists) < -1e-13 * fastest) approaching.push_back(region);
    }
    if (approaching.empty()) return all;
    for (const std::vector<std::size_t>& part : components(approaching, all.bodies)) {
      std::vector<Region> acting;
      for (const std::size_t i : part) acting.push_back(approaching[i]);
      act(acting, all.bodies, all.twists);
    }
    ++all.rounds;
  }
  for (Region& region : all.regions) region.restitution = 0;
  act(all.regions, all.bodies, all.twists);
  return all;
}

double energy(const Impacts& all) {
  double sum = 0;
  for (std::size_t i = 0; i < all.bodies.size(); ++i) {
    if (all.bodies[i].inverse_mass == 0) continue;
    const Twist& twist = all.twists[i];
    sum += twist.v.squaredNorm() / all.bodies[i].inverse_mass / 2;
    sum += twist.w.dot(all.bodies[i].inverse_inertia.inverse() * twist.w) / 2;
  }
  return sum;
}

bool is_near(const Vec3& a, const Vec3& b, double most = 1e-13) { return (a - b).norm() < most; }

using Corners = std::vector<std::pair<double, double>>;
const Corners four = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};

/// A body (0) over a fixed floor (1): vertical speed v, angular velocity (x, y), on regions of points (x, y).
Impacts on_floor(double inverse_moment, double v, double w_x, double w_y,
                 const std::vector<std::pair<Corners, double>>& regions, double height = 1, double friction = 0) {
  Impacts all;
  all.bodies = {{1, inverse_moment * Mat3::Identity()}, {}};
  all.twists = {{{0, 0, v}, {w_x, w_y, 0}}, {}};
  for (const auto& [corners, e] : regions) {
    Region& region = all.regions.emplace_back();
    region.restitution = e;
    for (const auto& [x, y] : corners) {
      region.points.push_back(point(0, 1, {0, 0, 1}, {x, y, -height}));
      region.points.back().friction = friction;
    }
  }
  return all;
}

/// The velocity along z, and the angular velocity about x and y. A cube of half side 1 has a moment of 2/3.
Vec3 cube_after(double v, double w_x, double w_y, const Corners& corners, double e) {
  const Impacts done = resolved(on_floor(1.5, v, w_x, w_y, {{corners, e}}));
  return {done.twists[0].v.z(), done.twists[0].w.x(), done.twists[0].w.y()};
}

Impacts row_of_balls(const std::vector<double>& speeds, double e, const std::vector<double>& masses = {}) {
  Impacts all;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    all.bodies.push_back({masses.empty() ? 1 : 1 / masses[i], Mat3::Identity()});
    all.twists.push_back({{speeds[i], 0, 0}, Vec3::Zero()});
    if (i == 0) continue;
    const int a = static_cast<int>(i);
    all.regions.push_back({e, {point(a, a - 1, {1, 0, 0}, {-1, 0, 0}, {1, 0, 0})}});
  }
  return all;
}

std::vector<double> speeds(const Impacts& all) {
  std::vector<double> of;
  for (const Twist& twist : all.twists) of.push_back(twist.v.x());
  return of;
}

bool are_near(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) < 1e-13; });
}

TEST_CASE("round: a cube that falls flat leaves with e times its speed, without spin, however its points are listed") {
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
TEST_CASE("round: a cube that falls on one edge") {
  CHECK(is_near(cube_after(-1, 0, 0, {{1, 1}, {-1, 1}}, 0.5), {-0.4, 0.9, 0}));
}

// A point about which it rotates does not approach, but carries: the region acts as a whole.
TEST_CASE("round: a body that rocks from one edge to the other") {
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

TEST_CASE("round: Newton's cradle") {
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

TEST_CASE("round: a disc breaks two symmetrically") {
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

Impacts ball_in_wedge(const Vec3& v, double x, double y, double e) {
  Impacts all;
  all.bodies = {{1, Mat3::Identity()}, {}, {}};
  all.twists = {{v, Vec3::Zero()}, {}, {}};
  const Vec3 right(x, y, 0), left(-x, y, 0);
  all.regions = {{e, {point(0, 1, right, -right)}}, {e, {point(0, 2, left, -left)}}};
  return all;
}

TEST_CASE("round: a ball in a wedge") {
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
  CHECK(after({1, 0, 0}, 1, 0, 1).norm() < 1e-13);
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

TEST_CASE("round: a beam on two pillars") {
  CHECK(is_near(beam_after({{{-3, -1}, 0.5}, {{1, 2}, 0.5}}), {0.5, 0, 0}));
  CHECK(is_near(beam_after({{{-1}, 0.5}, {{2}, 0.5}}), {0.5, 0, 0}));
}

// v' = s q. Pillars of one point: p = (2/3, 1/3), q = (2/3, 0), and 4/9 + (4/9)/3 = 16/27 is below twice the energy
// that may return, 2/3. Pillars of a width: of all p without a torque, (1/2, 1/2) at −1 and 1 has the least energy.
TEST_CASE("round: pillars of different restitution return what their own compression took at most") {
  CHECK(is_near(beam_after({{{-1}, 1}, {{2}, 0}}), {2.0 / 3, -2.0 / 9, 0}));
  for (const std::vector<double>& left : {std::vector<double>{-3, -1}, {-1, -3}, {-1, -2, -3, -1}}) {
    for (const std::vector<double>& right : {std::vector<double>{1, 3}, {3, 1}, {2, 3, 1}}) {
      CHECK(is_near(beam_after({{left, 1}, {right, 0}}), {0.5, -1.0 / 6, 0}, 1e-11));
      CHECK(is_near(beam_after({{right, 0}, {left, 1}}), {0.5, -1.0 / 6, 0}, 1e-11));
    }
  }
}

// n·n' = −9/10. Half of the compression's work belongs to each of the two regions, so a region with e = 1 may return
// half of the energy. Its e p alone would return five times the energy.
TEST_CASE("round: restitution is limited where one region's return would compress the other") {
  const double x = std::sqrt(1.9), y = std::sqrt(0.1);
  Impacts all = ball_in_wedge({0, -1, 0}, x / std::sqrt(2), y / std::sqrt(2), 1);
  all.regions[1].restitution = 0;
  const double before = energy(all);
  act(all.regions, all.bodies, all.twists);
  CHECK(energy(all) == Approx(before / 2).epsilon(1e-12));
}

TEST_CASE("round: a square that lands flat and slides keeps flat") {
  Impacts all = on_floor(1.5, -1, 0, 0, {{four, 0.5}}, 1, 0.5);
  all.twists[0].v.x() = 2;
  const Impacts done = resolved(all);
  CHECK(is_near(done.twists[0].v, {1.25, 0, 0.5}, 1e-11));
  CHECK(done.twists[0].w.norm() < 1e-11);
}

/// Balls, boxes on a floor and chains between them, drawn.
struct Draw {
  explicit Draw(unsigned seed) : generator(seed) {}
  double number() { return static_cast<double>(generator()) * 0x1p-31 - 1; }
  Vec3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  /// Three bodies and a fixed one, with four regions of one to five points, and masses that differ by up to `ratio`.
  Impacts scene(double ratio, double friction, bool one_e) {
    Impacts all;
    for (int i = 0; i < 3; ++i) {
      const double mass = i == 0 ? ratio : 1;
      Mat3 spread = Mat3::Identity();
      spread.col(0) += vector() / 2;
      const Mat3 inertia = mass * (spread * spread.transpose());
      all.bodies.push_back({1 / mass, inertia.inverse()});
      const Vec3 v = vector(), w = vector();
      all.twists.push_back({v, w});
    }
    all.bodies.emplace_back();
    all.twists.emplace_back();
    const std::vector<std::pair<int, int>> pairs = {{0, 3}, {1, 3}, {0, 1}, {1, 2}};
    const double e = (number() + 1) / 2;
    for (const auto& [a, b] : pairs) {
      Region& region = all.regions.emplace_back();
      region.restitution = one_e ? e : (number() + 1) / 2;
      const Vec3 n = vector().normalized(), t = n.unitOrthogonal(), s = n.cross(t);
      const Vec3 arm_A = vector(), arm_B = vector();
      const int count = 1 + static_cast<int>(generator() % 5);
      for (int k = 0; k < count; ++k) {
        const double x = number(), y = number();
        const Vec3 off = x * t + y * s;
        region.points.push_back(point(a, b, n, arm_A + off, b == 3 ? Vec3(Vec3::Zero()) : Vec3(arm_B + off)));
        region.points.back().friction = friction;
      }
    }
    return all;
  }

  std::mt19937 generator;
};

Vec3 momentum(const Impacts& all, const std::vector<Region>& regions) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 3; ++i)
    sum += all.twists[static_cast<std::size_t>(i)].v / all.bodies[static_cast<std::size_t>(i)].inverse_mass;
  for (const Region& region : regions) {
    for (const ContactRow& row : region.points) sum -= row.b == 3 ? row.P : Vec3(Vec3::Zero());
  }
  return sum;
}

std::vector<Region> approaching(const Impacts& all) {
  std::vector<Region> some;
  for (const Region& region : all.regions) {
    if (least_normal_velocity(region, all.twists) < 0) some.push_back(region);
  }
  return some;
}

TEST_CASE("round: it pushes only, keeps momentum, stays in the cone and returns no more energy than e allows") {
  for (const double ratio : {1.0, 1e6, 1e-6}) {
    for (const double friction : {0.0, 0.3}) {
      for (unsigned seed = 0; seed < 60; ++seed) {
        INFO("ratio " << ratio << ", friction " << friction << ", seed " << seed);
        Draw draw(seed);
        Impacts all = draw.scene(ratio, friction, seed % 2 == 0);
        std::vector<Region> acting = approaching(all);
        if (acting.empty() || components(acting, all.bodies).size() > 1) continue;
        const double before = energy(all);
        const Vec3 momentum_before = momentum(all, {});
        act(acting, all.bodies, all.twists);
        CHECK(energy(all) <= before * (1 + 1e-12));
        CHECK((momentum(all, acting) - momentum_before).norm() <= 1e-11 * std::max(ratio, 1.0));
        for (const Region& region : acting) {
          for (const ContactRow& row : region.points) {
            const double p = row.n.dot(row.P);
            CHECK(p >= 0);
            CHECK((row.P - p * row.n).norm() <= friction * p + 1e-12 * row.P.norm());
          }
        }
      }
    }
  }
}

TEST_CASE("round: without friction and with one e, energy falls by 1 - e² of what compression takes") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    Impacts all = Draw(seed).scene(1, 0, true);
    std::vector<Region> acting = approaching(all);
    if (acting.empty()) continue;
    const double e = acting.front().restitution, before = energy(all);
    Impacts compressed = all;
    std::vector<Region> plastic = acting;
    for (Region& region : plastic) region.restitution = 0;
    act(plastic, compressed.bodies, compressed.twists);
    for (const Region& region : plastic) CHECK(least_normal_velocity(region, compressed.twists) >= -1e-12);
    act(acting, all.bodies, all.twists);
    CHECK(before - energy(all) == Approx((1 - e * e) * (before - energy(compressed))).margin(1e-12));
  }
}

TEST_CASE("round: the order of points and regions, repeated and added points and exchanged bodies change nothing") {
  for (unsigned seed = 0; seed < 80; ++seed) {
    INFO("seed " << seed);
    Draw draw(seed);
    const Impacts all = draw.scene(1, 0, seed % 2 == 0);
    Impacts plain = all, other = all;
    plain.regions = approaching(all);
    other.regions = plain.regions;
    if (plain.regions.empty()) continue;
    std::ranges::reverse(other.regions);
    for (Region& region : other.regions) {
      std::ranges::reverse(region.points);
      region.points.push_back(region.points.front());
      ContactRow middle = region.points.front();
      middle.arm_A =
          (middle.arm_A + region.points.back().arm_A + 2 * region.points[region.points.size() / 2].arm_A) / 4;
      middle.arm_B =
          (middle.arm_B + region.points.back().arm_B + 2 * region.points[region.points.size() / 2].arm_B) / 4;
      region.points.push_back(middle);
      for (ContactRow& row : region.points) {
        std::swap(row.a, row.b);
        std::swap(row.arm_A, row.arm_B);
        row.n = -row.n;
      }
    }
    act(plain.regions, plain.bodies, plain.twists);
    act(other.regions, other.bodies, other.twists);
    for (std::size_t i = 0; i < plain.twists.size(); ++i) {
      CHECK(is_near(plain.twists[i].v, other.twists[i].v, 1e-9));
      CHECK(is_near(plain.twists[i].w, other.twists[i].w, 1e-9));
    }
  }
}

TEST_CASE("round: points a nanometre apart, a region that is nearly a line, and a needle") {
  const double d = 1e-9;
  CHECK(is_near(cube_after(-1, 0, 0, {{d, d}, {d, -d}, {-d, -d}, {-d, d}}, 0.5), {0.5, 0, 0}, 1e-8));
  CHECK(is_near(cube_after(-1, 0, 0, {{1, d}, {1, -d}, {-1, -d}, {-1, d}}, 0.5), {0.5, 0, 0}, 1e-8));
  for (const double inverse_moment : {1e-9, 1e9}) {
    const Impacts done = resolved(on_floor(inverse_moment, -1, 0, 0, {{four, 0.5}}));
    CHECK(is_near(done.twists[0].v, {0, 0, 0.5}, 1e-10));
    CHECK(done.twists[0].w.norm() < 1e-10 * std::max(1.0, std::sqrt(inverse_moment)));
  }
}

TEST_CASE("round: a heavy body on a light one on the floor") {
  for (const double mass : {1e6, 1e-6}) {
    Impacts all = row_of_balls({0, -1, -1}, 0, {1, 1, mass});
    all.bodies[0] = {};  // fixed
    const Impacts done = resolved(all);
    CHECK(are_near(speeds(done), {0, 0, 0}));
  }
}

TEST_CASE("components: regions are connected through bodies that move alone") {
  const Impacts all = row_of_balls({1, 0, 0, 0, 0}, 1);
  std::vector<Region> regions = all.regions;
  std::vector<Mobility> bodies = all.bodies;
  CHECK(components(regions, bodies).size() == 1);
  bodies[2] = {};
  CHECK(components(regions, bodies) == std::vector<std::vector<std::size_t>>{{0, 1}, {2, 3}});
  CHECK(components({}, bodies).empty());
}

}  // namespace
}  // namespace touchstone::fast::simultaneous
