// Impacts at several points at one instant: the laws that every outcome must obey, on drawn scenes and near limits.
#include "fast/simultaneous/round.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "tests/catch.h"
#include "tests/fast/simultaneous/impacts.h"

namespace touchstone::fast::simultaneous {
namespace {

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

  /// A body that hits three fixed planes at a point each.
  Impacts corner() {
    Impacts all;
    Mat3 spread = Mat3::Identity();
    spread.col(0) += vector() / 2;
    const Mat3 inertia = std::pow(10, 2 * number()) * (spread * spread.transpose());
    all.bodies = {{1, inertia.inverse()}, {}};
    const Vec3 v = vector(), w = vector();
    all.twists = {{v, w}, {}};
    for (int k = 0; k < 3; ++k) {
      Region& region = all.regions.emplace_back();
      region.restitution = (number() + 1) / 2;
      const Vec3 n = vector().normalized(), arm = vector();
      region.points = {point(0, 1, n, arm)};
      region.points.front().friction = 1.5 * (number() + 1);
    }
    return all;
  }

  /// A box that lands on two blocks side by side, of unlike e and with friction up to `most`.
  Impacts landing(double most) {
    Impacts all;
    const Vec3 size = vector(), slide = vector();
    const Vec3 half(1 + size.x() / 2, 1 + size.y() / 2, 0.5), square = half.cwiseAbs2();
    const Vec3 inertia = (square.sum() * Vec3::Ones() - square) / 3;
    all.bodies = {{1, inertia.cwiseInverse().asDiagonal()}, {}};
    all.twists = {{Vec3(slide.x(), slide.y(), -1), Vec3::Zero()}, {}};
    const double middle = number() / 2 * half.x();
    for (const double end : {-half.x(), half.x()}) {
      Region& region = all.regions.emplace_back();
      region.restitution = (number() + 1) / 2;
      const double friction = (number() + 1) / 2 * most;
      for (const double x : {middle, end}) {
        for (const double y : {-half.y(), half.y()}) {
          region.points.push_back(point(0, 1, {0, 0, 1}, {x, y, -half.z()}));
          region.points.back().friction = friction;
        }
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

/// The same regions in reverse order, with points in reverse order and bodies exchanged.
std::vector<Region> reversed(std::vector<Region> regions) {
  std::ranges::reverse(regions);
  for (Region& region : regions) {
    std::ranges::reverse(region.points);
    for (ContactRow& row : region.points) {
      std::swap(row.a, row.b);
      std::swap(row.arm_A, row.arm_B);
      row.n = -row.n;
    }
  }
  return regions;
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
    if (plain.regions.empty()) continue;
    other.regions = reversed(plain.regions);
    for (Region& region : other.regions) {
      region.points.push_back(region.points.front());
      ContactRow middle = region.points.front();
      middle.arm_A =
          (middle.arm_A + region.points.back().arm_A + 2 * region.points[region.points.size() / 2].arm_A) / 4;
      middle.arm_B =
          (middle.arm_B + region.points.back().arm_B + 2 * region.points[region.points.size() / 2].arm_B) / 4;
      region.points.push_back(middle);
    }
    act(plain.regions, plain.bodies, plain.twists);
    act(other.regions, other.bodies, other.twists);
    for (std::size_t i = 0; i < plain.twists.size(); ++i) {
      CHECK(is_near(plain.twists[i].v, other.twists[i].v, 1e-9));
      CHECK(is_near(plain.twists[i].w, other.twists[i].w, 1e-9));
    }
  }
}

// Friction may return energy in compression: what u_n alone tells of its work is too much then.
TEST_CASE("round: with friction above 1 no more energy returns than compression took") {
  for (unsigned seed = 0; seed < 1500; ++seed) {
    INFO("seed " << seed);
    Impacts all = Draw(seed).corner();
    std::vector<Region> acting = approaching(all);
    if (acting.empty()) continue;
    const double before = energy(all);
    act(acting, all.bodies, all.twists);
    CHECK(energy(all) <= before * (1 + 1e-12));
  }
}

// What the turns have not reached depends on the order; 2⁻¹⁰ is what TS-SIMULATION-30 allows.
TEST_CASE("round: with friction the order of points and regions and exchanged bodies change little") {
  for (unsigned seed = 0; seed < 160; ++seed) {
    INFO("seed " << seed);
    const Impacts all = seed % 2 == 0 ? Draw(seed).scene(1, 0.3, false) : Draw(seed).landing(0.5);
    Impacts plain = all, other = all;
    plain.regions = approaching(all);
    if (plain.regions.empty()) continue;
    other.regions = reversed(plain.regions);
    const double before = energy(all);
    act(plain.regions, plain.bodies, plain.twists);
    act(other.regions, other.bodies, other.twists);
    CHECK(energy(plain) <= before * (1 + 1e-12));
    for (std::size_t i = 0; i < plain.twists.size(); ++i) {
      CHECK(is_near(plain.twists[i].v, other.twists[i].v, 0x1p-10));
      CHECK(is_near(plain.twists[i].w, other.twists[i].w, 0x1p-10));
    }
  }
}

// The regions are redundant: how the two blocks share the load is not determined by equilibrium, and friction and
// restitution depend on it.
TEST_CASE("round: a box that lands on two blocks of unlike material leaves mirrored if it is mirrored") {
  const auto landing = [](double side) {
    Impacts all;
    all.bodies = {{1.0 / 16, Vec3(1.25, 16.25, 17).cwiseInverse().asDiagonal() * (3.0 / 16)}, {}};
    all.twists = {{{-side, 0, -2}, Vec3::Zero()}, {}};
    for (const double block : {1.0, -1.0}) {
      Region& region = all.regions.emplace_back();
      region.restitution = block > 0 ? 1 : 0;
      for (const double x : {0.0, 4 * block}) {
        for (const double y : {-1.0, 1.0}) {
          region.points.push_back(point(0, 1, {0, 0, 1}, {side * x, y, -0.5}));
          region.points.back().friction = block > 0 ? 0 : 1;
        }
      }
    }
    act(all.regions, all.bodies, all.twists);
    return all.twists[0];
  };
  const Twist right = landing(1), left = landing(-1);
  CHECK(right.v.z() > 0);
  CHECK(std::abs(right.v.y()) + std::abs(right.w.x()) + std::abs(right.w.z()) <= rounding);
  CHECK(is_near(right.v, Vec3(-left.v.x(), left.v.y(), left.v.z()), rounding));
  CHECK(is_near(right.w, Vec3(left.w.x(), -left.w.y(), -left.w.z()), rounding));
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
