// Bodies that touch in regions, and the rounds that resolve their impacts.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fast/simultaneous/round.h"

namespace touchstone::fast::simultaneous {

using contact::ContactRow;
using contact::Mobility;
using contact::Twist;

/// m/s, where the greatest speed is 1; derived in scenes_test.cpp.
constexpr double rounding = 0x1p-43;

/// Bodies and the regions at which they touch.
struct Impacts {
  std::vector<Mobility> bodies;
  std::vector<Twist> twists;
  std::vector<Region> regions;
  int rounds = 0;
};

inline ContactRow point(int a, int b, const Vec3& n, const Vec3& arm_A, const Vec3& arm_B = Vec3::Zero()) {
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
inline Impacts resolved(Impacts all, int most_rounds = 64) {
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

inline double energy(const Impacts& all) {
  double sum = 0;
  for (std::size_t i = 0; i < all.bodies.size(); ++i) {
    if (all.bodies[i].inverse_mass == 0) continue;
    const Twist& twist = all.twists[i];
    sum += twist.v.squaredNorm() / all.bodies[i].inverse_mass / 2;
    sum += twist.w.dot(all.bodies[i].inverse_inertia.inverse() * twist.w) / 2;
  }
  return sum;
}

inline bool is_near(const Vec3& a, const Vec3& b, double most = rounding) { return (a - b).norm() < most; }

using Corners = std::vector<std::pair<double, double>>;
inline const Corners four = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};

/// A body (0) over a fixed floor (1): vertical speed v, angular velocity (x, y), on regions of points (x, y).
inline Impacts on_floor(double inverse_moment, double v, double w_x, double w_y,
                        const std::vector<std::pair<Corners, double>>& regions, double height = 1,
                        double friction = 0) {
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
inline Vec3 cube_after(double v, double w_x, double w_y, const Corners& corners, double e) {
  const Impacts done = resolved(on_floor(1.5, v, w_x, w_y, {{corners, e}}));
  return {done.twists[0].v.z(), done.twists[0].w.x(), done.twists[0].w.y()};
}

inline Impacts row_of_balls(const std::vector<double>& speeds, double e, const std::vector<double>& masses = {}) {
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

inline std::vector<double> speeds(const Impacts& all) {
  std::vector<double> of;
  for (const Twist& twist : all.twists) of.push_back(twist.v.x());
  return of;
}

inline bool are_near(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) < rounding; });
}

inline Impacts ball_in_wedge(const Vec3& v, double x, double y, double e) {
  Impacts all;
  all.bodies = {{1, Mat3::Identity()}, {}, {}};
  all.twists = {{v, Vec3::Zero()}, {}, {}};
  const Vec3 right(x, y, 0), left(-x, y, 0);
  all.regions = {{e, {point(0, 1, right, -right)}}, {e, {point(0, 2, left, -left)}}};
  return all;
}

}  // namespace touchstone::fast::simultaneous
