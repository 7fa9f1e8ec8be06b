#include "tests/bench/distance/workload.h"

#include <Eigen/Geometry>
#include <algorithm>
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

struct Kind {
  std::string name;
  bool coherent = false;
  std::size_t pairs = 1;
  double apart = 1;  ///< factor of the distance of the origins
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{{"coherent", true, 1, 1},
                                     {"cold", false, 1, 1},
                                     {"coherent_100", true, 100, 1},
                                     {"cold_100", false, 100, 1},
                                     {"coherent_1000", true, 1000, 1},
                                     {"cold_1000", false, 1000, 1},
                                     {"once", false, 1, 1},
                                     {"once_overlapping", false, 1, 0.3},
                                     {"once_touching", false, 1, 1}};
  return all;
}

constexpr std::size_t different_pairs = 32;

Dice dice_of(int vertices, std::size_t pair) {
  return Dice(static_cast<unsigned>(vertices) + 10000 * static_cast<unsigned>(pair));
}

FrameSequence moving(const Kind& kind, const Polytope& A, const Polytope& B, Dice& dice, std::size_t frames) {
  FrameSequence sequence{A, B, {}};
  const Turn spin_A(Eigen::AngleAxisd(std::numbers::pi / 18, dice.direction()));
  const Turn spin_B(Eigen::AngleAxisd(std::numbers::pi / 18, dice.direction()));
  const Vec3 p_WA = dice.direction();
  Turn q_A = any_turn(dice);
  Turn q_B = any_turn(dice);
  Vec3 apart = 2.5 * dice.direction();
  for (std::size_t i = 0; i < frames; ++i) {
    sequence.frames.push_back({{p_WA, as_model(q_A)}, {p_WA + kind.apart * apart, as_model(q_B)}});
    q_A = kind.coherent ? (spin_A * q_A).normalized() : any_turn(dice);
    q_B = kind.coherent ? (spin_B * q_B).normalized() : any_turn(dice);
    Vec3 next;
    do {
      next = kind.coherent ? Vec3(apart + 0.05 * dice.direction())
                           : Vec3(farthest * dice.direction() * std::abs(dice.around_zero()));
    } while (next.norm() < nearest || next.norm() > farthest);
    apart = next;
  }
  return sequence;
}

/// x ↦ 2v − x for each vertex v of A in turn. All of it is exact: the two have v in common, and nothing else.
FrameSequence touching(const Polytope& A, std::size_t frames) {
  std::vector<Vec3> mirrored;
  for (const Vec3& v : A.vertices) mirrored.push_back(-v);
  FrameSequence sequence{A, reference::convex_hull(mirrored), {}};
  for (std::size_t i = 0; i < frames; ++i) {
    sequence.frames.push_back({{}, {2 * A.vertices[i % A.vertices.size()], {}}});
  }
  return sequence;
}

}  // namespace

std::vector<std::string> workloads() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds()) names.push_back(kind.name);
  return names;
}

bool asks_once(const std::string& workload) { return workload.starts_with("once"); }

std::vector<FrameSequence> shoot(const std::string& workload, int vertices, std::size_t frames) {
  const Kind& kind = *std::ranges::find(kinds(), workload, &Kind::name);
  const std::size_t each = std::max<std::size_t>(8, frames / kind.pairs);
  std::vector<FrameSequence> all;
  for (std::size_t i = 0; i < kind.pairs; ++i) {
    Dice dice = dice_of(vertices, i);
    if (i >= different_pairs) {
      const FrameSequence& same = all[i % different_pairs];
      all.push_back(moving(kind, same.A, same.B, dice, each));
      continue;
    }
    const Polytope A = ball(dice, vertices);
    if (workload == "once_touching") {
      all.push_back(touching(A, each));
    } else {
      const Polytope B = ball(dice, vertices);
      all.push_back(moving(kind, A, B, dice, each));
    }
  }
  return all;
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
