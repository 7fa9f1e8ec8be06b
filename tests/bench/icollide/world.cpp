#include "tests/bench/icollide/world.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "reference/convex_hull.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::bench {
namespace {

constexpr int shapes = 40;  // one hull per body would only use memory, with 3,000 bodies

Vec3 direction(tests::Dice& dice) {
  while (true) {
    const Vec3 p = dice.in_cube();
    if (p.norm() > 0.1 && p.norm() < 1) return p.normalized();
  }
}

Polytope random_polytope(tests::Dice& dice, const Parameters& parameters) {
  std::vector<Vec3> points;
  for (int i = 0; i < parameters.faces / 2 + 2; ++i) {
    Vec3 p = direction(dice);
    p.z() *= parameters.stretch;
    points.push_back(p);
  }
  return reference::convex_hull(points);
}

double volume(const Polytope& polytope) {
  double sixfold = 0;
  for (const std::vector<int>& face : polytope.faces) {
    const auto at = [&](std::size_t i) { return polytope.vertices[static_cast<std::size_t>(face[i])]; };
    for (std::size_t i = 2; i < face.size(); ++i) sixfold += at(0).dot(at(i - 1).cross(at(i)));
  }
  return sixfold / 6;
}

}  // namespace

World::World(const Parameters& parameters, std::uint64_t seed) : turn_(parameters.turn * std::numbers::pi / 180) {
  tests::Dice dice(seed);
  std::vector<Polytope> hulls;
  for (int i = 0; i < shapes; ++i) hulls.push_back(random_polytope(dice, parameters));
  double total = 0;
  for (int i = 0; i < parameters.bodies; ++i) {
    bodies_.push_back(tests::body(hulls[static_cast<std::size_t>(i % shapes)]));
    total += volume(hulls[static_cast<std::size_t>(i % shapes)]);
    velocity_.push_back(parameters.step * direction(dice));
    axis_.push_back(direction(dice));
  }
  room_ = std::cbrt(total / parameters.density) / 2;
  for (Body& body : bodies_) body.X_WB.p_WB = room_ * dice.in_cube();
  advance();
}

void World::advance() {
  ++frame_;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Vec3& p = bodies_[i].X_WB.p_WB;
    Vec3& v = velocity_[i];
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (std::abs(p[k] + v[k]) > room_) v[k] = -v[k];
    }
    p += v;
    const double half = turn_ * (frame_ + static_cast<double>(i)) / 2;
    const Vec3 xyz = std::sin(half) * axis_[i];
    bodies_[i].X_WB.q_WB = {std::cos(half), xyz.x(), xyz.y(), xyz.z()};
  }
}

void World::exchange_velocities(std::size_t a, std::size_t b) { std::swap(velocity_[a], velocity_[b]); }

}  // namespace touchstone::bench
