#include "tests/bench/broad_phase/workload.h"

#include <cmath>

#include "tests/reference/hard_pairs.h"

namespace touchstone::bench {
namespace {

using tests::Dice;

constexpr double ten_degrees = 0.17453292519943295;

struct MovingBox {
  Vec3 centre;
  Vec3 half;
  Vec3 velocity;  // per frame
  Vec3 phase;     // of the extents of the rotating body's box
};

Vec3 direction(Dice& dice) { return dice.in_cube().normalized(); }

/// The box of a tumbling round body varies by some 15 %.
Vec3 half_at(const MovingBox& moving, double frame) {
  return moving.half.array() * (0.925 + 0.075 * (moving.phase.array() + frame * ten_degrees).sin());
}

/// The side (m) of the cube of which n bodies of radius 1, hulls of 20 points (36 faces, 2.5 m³), fill 1 %.
double side_of_one_percent(std::size_t bodies) { return std::cbrt(250 * static_cast<double>(bodies)); }

MovingBox tumbling(Dice& dice, const Vec3& centre, double radius) {
  return {centre, Vec3::Constant(radius), 0.1 * radius * direction(dice), 3 * dice.in_cube()};
}

std::vector<MovingBox> moving_boxes(const std::string& workload, std::size_t bodies, Dice& dice) {
  std::vector<MovingBox> all;
  const double n = static_cast<double>(bodies);
  for (std::size_t i = 0; i < bodies; ++i) {
    if (workload == "ratio") {
      // Sizes from 1/1000 to 1, equally many in each octave; the boxes fill 5 % of the cube.
      const double radius = 0.5 * std::pow(1000, -dice.unit());
      const double side = std::cbrt(n / (0.05 * 3 * std::log(1000)));
      all.push_back(tumbling(dice, side / 2 * dice.in_cube(), radius));
    } else if (workload == "clustered") {
      // Clusters of 250 bodies, each with a density of 5 %, in a cube of 1000 times their total volume.
      Dice of_cluster(1000 + i / 250);
      const Vec3 cluster = side_of_one_percent(bodies) / std::cbrt(5) * 5 * of_cluster.in_cube();
      all.push_back(tumbling(dice, cluster + side_of_one_percent(250) / std::cbrt(5) / 2 * dice.in_cube(), 1));
    } else {
      all.push_back(tumbling(dice, side_of_one_percent(bodies) / 2 * dice.in_cube(), 1));
    }
  }
  return all;
}

/// `spread`: sizes differ by this much at most. Without it neighbours are as far apart as the jitter moves them, so
/// their pairs begin and end from frame to frame.
std::vector<Aabb> settled_picture(std::size_t bodies, double spread, Dice& jitter) {
  const auto row = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(bodies))));
  std::vector<Aabb> boxes;
  Dice sizes(7);
  for (std::size_t i = 0; i < bodies; ++i) {
    const Vec3 half = 0.5 * Vec3(1 + spread * sizes.around_zero(), 1 + spread * sizes.around_zero(), 1);
    const Vec3 centre = Vec3(double(i % row), double(i / row), 0.5) + 1e-3 * jitter.in_cube();
    boxes.push_back({centre - half, centre + half});
  }
  return boxes;
}

bool is_mostly_still(const std::string& workload) { return workload == "still" || workload == "announced"; }

std::vector<std::vector<Aabb>> pictures(const std::string& workload, std::size_t bodies, std::size_t frames) {
  Dice dice(5);
  std::vector<MovingBox> all = moving_boxes(workload, bodies, dice);
  std::vector<std::vector<Aabb>> sequence;
  for (std::size_t f = 0; f <= frames; ++f) {
    if (workload == "settled" || workload == "flickering") {
      sequence.push_back(settled_picture(bodies, workload == "settled" ? 0.2 : 0, dice));
      continue;
    }
    if (workload == "teleport") all = moving_boxes(workload, bodies, dice);
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < bodies; ++i) {
      const bool moves = f > 0 && (!is_mostly_still(workload) || dice.between(1, 100) == 1);
      if (moves) all[i].centre += all[i].velocity;
      if (f > 0 && !moves) {
        boxes.push_back(sequence.back()[i]);
        continue;
      }
      const Vec3 half = half_at(all[i], static_cast<double>(f));
      boxes.push_back({all[i].centre - half, all[i].centre + half});
    }
    sequence.push_back(std::move(boxes));
  }
  return sequence;
}

/// `all`: also the boxes that have not changed.
Frame changes(const std::vector<Aabb>& from, const std::vector<Aabb>& to, bool all) {
  Frame frame;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (all || !(from[i] == to[i])) frame.push_back({i, to[i]});
  return frame;
}

}  // namespace

const std::vector<std::string>& workloads() {
  static const std::vector<std::string> names{"coherent",  "settled",  "flickering", "ratio",
                                              "clustered", "teleport", "still",      "announced"};
  return names;
}

FrameSequence shoot(const std::string& workload, std::size_t bodies, std::size_t frames) {
  const auto sequence = pictures(workload, bodies, frames);
  FrameSequence shot;
  shot.start = sequence.front();
  shot.world = sequence.front().front();
  for (const auto& picture : sequence) {
    for (const Aabb& box : picture) {
      shot.world.lo = shot.world.lo.cwiseMin(box.lo);
      shot.world.hi = shot.world.hi.cwiseMax(box.hi);
    }
  }
  const bool all = workload == "announced";
  for (std::size_t f = 0; f + 1 < sequence.size(); ++f) {
    shot.forward.push_back(changes(sequence[f], sequence[f + 1], all));
    shot.backward.push_back(changes(sequence[f + 1], sequence[f], all));
  }
  return shot;
}

}  // namespace touchstone::bench
