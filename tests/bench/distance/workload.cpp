#include "tests/bench/distance/workload.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "reference/convex_hull.h"

namespace touchstone::bench {
namespace {

/// The engine of <random> gives the same numbers everywhere; its distributions do not.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  double around_zero() { return 2 * (static_cast<double>(engine_()) * 0x1p-32) - 1; }

  Vec3 direction() {
    while (true) {
      const Vec3 v{around_zero(), around_zero(), around_zero()};
      const double length = v.norm();
      if (length > 0.1 && length <= 1) return v / length;
    }
  }

 private:
  std::mt19937 engine_;
};

Polytope ball(Dice& dice, int vertices) {
  std::vector<Vec3> points;
  for (int i = 0; i < vertices; ++i) points.push_back(dice.direction());
  return reference::convex_hull(points);
}

using Turn = Eigen::Quaterniond;

Quaternion as_model(const Turn& q) { return {q.w(), q.x(), q.y(), q.z()}; }

constexpr double nearest = 2.05;
constexpr double farthest = 3;

Turn any_turn(Dice& dice) { return Turn(Eigen::AngleAxisd(std::numbers::pi * dice.around_zero(), dice.direction())); }

}  // namespace

std::vector<std::string> workloads() { return {"coherent", "cold"}; }

FrameSequence shoot(const std::string& workload, int vertices, std::size_t frames) {
  Dice dice(static_cast<unsigned>(vertices));
  FrameSequence sequence{ball(dice, vertices), ball(dice, vertices), {}};
  const Turn spin_A(Eigen::AngleAxisd(std::numbers::pi / 18, dice.direction()));
  const Turn spin_B(Eigen::AngleAxisd(std::numbers::pi / 18, dice.direction()));
  const Vec3 p_WA = dice.direction();
  Turn q_A = any_turn(dice);
  Turn q_B = any_turn(dice);
  Vec3 apart = 2.5 * dice.direction();
  const bool coherent = workload == "coherent";
  for (std::size_t i = 0; i < frames; ++i) {
    sequence.frames.push_back({{p_WA, as_model(q_A)}, {p_WA + apart, as_model(q_B)}});
    q_A = coherent ? (spin_A * q_A).normalized() : any_turn(dice);
    q_B = coherent ? (spin_B * q_B).normalized() : any_turn(dice);
    Vec3 next;
    do {
      next = coherent ? Vec3(apart + 0.05 * dice.direction())
                      : Vec3(farthest * dice.direction() * std::abs(dice.around_zero()));
    } while (next.norm() < nearest || next.norm() > farthest);
    apart = next;
  }
  return sequence;
}

Scene scene_of(const FrameSequence& sequence, const FrameSequence::Poses& poses) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = sequence.A;
  scene.bodies[0].X_WB = poses.X_WA;
  scene.bodies[1].shape = sequence.B;
  scene.bodies[1].X_WB = poses.X_WB;
  return scene;
}

}  // namespace touchstone::bench
