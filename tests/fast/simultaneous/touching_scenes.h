// Drawn scenes of balls and boxes that are in contact at the start, exactly, and collide there at several points.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "model/scene.h"
#include "reference/impact_conditions.h"

namespace touchstone::fast::simultaneous {

/// The region in which two balls, or two boxes along the axes, touch; none if they do not.
inline std::optional<reference::ContactRegion> touching(const std::vector<Body>& bodies, int a, int b) {
  const Body &A = bodies[static_cast<std::size_t>(a)], &B = bodies[static_cast<std::size_t>(b)];
  const Vec3 apart = A.X_WB.p_WB - B.X_WB.p_WB;
  const auto *ball_a = std::get_if<Sphere>(&A.shape), *ball_b = std::get_if<Sphere>(&B.shape);
  if (ball_a != nullptr && ball_b != nullptr) {
    const double reach = ball_a->radius + ball_b->radius;
    if (apart.squaredNorm() != reach * reach) return std::nullopt;
    return reference::ContactRegion{a, b, apart, {B.X_WB.p_WB + ball_b->radius / reach * apart}};
  }
  const auto *box_a = std::get_if<Box>(&A.shape), *box_b = std::get_if<Box>(&B.shape);
  if (box_a == nullptr || box_b == nullptr) return std::nullopt;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(apart[axis]) != box_a->half_extents[axis] + box_b->half_extents[axis]) continue;
    const Vec3 low = (A.X_WB.p_WB - box_a->half_extents).cwiseMax(B.X_WB.p_WB - box_b->half_extents);
    const Vec3 high = (A.X_WB.p_WB + box_a->half_extents).cwiseMin(B.X_WB.p_WB + box_b->half_extents);
    reference::ContactRegion region{a, b, Vec3::Zero(), {}};
    region.nhat_BA_W[axis] = apart[axis] > 0 ? 1 : -1;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (low[u] >= high[u] || low[v] >= high[v]) return std::nullopt;
    for (const double x : {low[u], high[u]}) {
      for (const double y : {low[v], high[v]}) {
        Vec3& corner = region.points_W.emplace_back(low);
        corner[u] = x;
        corner[v] = y;
      }
    }
    return region;
  }
  return std::nullopt;
}

inline std::vector<reference::ContactRegion> all_touching(const std::vector<Body>& bodies) {
  std::vector<reference::ContactRegion> regions;
  for (int b = 1; b < static_cast<int>(bodies.size()); ++b) {
    for (int a = 0; a < b; ++a) {
      if (is_fixed(bodies[static_cast<std::size_t>(a)]) && is_fixed(bodies[static_cast<std::size_t>(b)])) continue;
      if (auto region = touching(bodies, a, b)) regions.push_back(*std::move(region));
    }
  }
  return regions;
}

/// A row of balls, a ball that breaks two, one in a wedge, a box on a table or pillars, or two boxes above one another.
/// Places are multiples of 1/8, so that contacts are exact.
class TouchingScenes {
 public:
  explicit TouchingScenes(unsigned seed) : generator_(seed) {}

  std::vector<Body> next() {
    bodies_.clear();
    const int kind = below(6);
    if (kind == 0) row();
    if (kind == 1) breaks(false);
    if (kind == 2) breaks(true);
    if (kind >= 3) boxes(kind - 3);
    const double friction = below(2) == 0 ? 0 : eighths(1, 8), e = below(9) / 8.0;
    const bool one_e = below(3) > 0;
    for (Body& body : bodies_) body.material = {one_e ? e : below(9) / 8.0, friction};
    return bodies_;
  }

 private:
  int below(int count) { return static_cast<int>(generator_() % static_cast<unsigned>(count)); }
  double eighths(int least, int most) { return (least + below(most - least + 1)) / 8.0; }
  double number() { return static_cast<double>(generator_()) * 0x1p-31 - 1; }
  Vec3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  Body& add(Shape shape, const Vec3& place) {
    Body& body = bodies_.emplace_back();
    body.shape = std::move(shape);
    body.X_WB.p_WB = place;
    return body;
  }

  Body& ball(double radius, const Vec3& place) {
    Body& body = add(Sphere{radius}, place);
    const double mass = eighths(1, 32);
    body.mass = MassProperties{mass, Vec3::Zero(), 0.4 * mass * radius * radius * Mat3::Identity()};
    return body;
  }

  /// Balls in touch along x. Each moves along x, and half of the rows otherwise too.
  void row() {
    double x = 0;
    const bool along = below(2) == 0;
    for (int count = 3 + below(4); count > 0; --count) {
      const double radius = eighths(1, 16);
      x += radius;
      Body& body = ball(radius, {x, 0, 0});
      x += radius;
      body.velocity.v_WBcm = along ? Vec3(number(), 0, 0) : vector();
      if (!along) body.velocity.w_WB = vector();
    }
  }

  /// A ball onto two others, at rest or fixed, with normals (4, ±3)/5.
  void breaks(bool fixed) {
    Body& striker = ball(2.5, {0, 0, 0});
    striker.velocity.v_WBcm = below(3) == 0 ? Vec3(1, 0, 0) : Vec3(1, number() / 2, number());
    for (const double y : {3.0, -3.0}) {
      Body& other = ball(2.5, {4, y, 0});
      if (fixed) other.mass = Fixed{};
    }
    if (below(2) == 0) std::swap(bodies_[0], bodies_[static_cast<std::size_t>(1 + below(2))]);
  }

  Body& box(const Vec3& half, const Vec3& place) {
    Body& body = add(Box{half}, place);
    body.mass = Density{eighths(1, 16)};
    return body;
  }

  Vec3 half_sides() {
    const double x = eighths(2, 16), y = eighths(2, 16);
    return {x, y, eighths(2, 16)};
  }

  /// A box falls on a table (0), on two pillars (1), or on another box that lies on a table (2).
  void boxes(int kind) {
    const Vec3 half = half_sides();
    double floor = 0;
    if (kind == 2) {
      const Vec3 lower = half_sides();
      floor = 2 * lower.z();
      box(lower, {eighths(-2, 2), eighths(-2, 2), lower.z()});
    }
    Body& falling = box(half, {0, 0, floor + half.z()});
    falling.velocity.v_WBcm = below(2) == 0 ? Vec3(0, 0, -1) : Vec3(number(), number(), -1);
    if (below(2) == 0) falling.velocity.w_WB = vector() / 2;
    if (kind == 1) {
      for (const double side : {-1.0, 1.0}) add(Box{Vec3(0.125, 4, 1)}, {side * half.x(), 0, -1}).mass = Fixed{};
    } else {
      add(Box{Vec3(8, 8, 1)}, {0, 0, -1}).mass = Fixed{};
    }
  }

  std::mt19937 generator_;
  std::vector<Body> bodies_;
};

}  // namespace touchstone::fast::simultaneous
