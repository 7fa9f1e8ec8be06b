#include "fast/simulation/prediction/hash_grid.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/broad_phase/sequence.h"

namespace touchstone::fast::simulation {
namespace {

using tests::Dice;

std::vector<BodyId> sorted_neighbours(HashGrid& hash_grid, BodyId id) {
  const std::span<const BodyId> near = hash_grid.neighbours(id);
  std::vector<BodyId> ids(near.begin(), near.end());
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// A hash grid and a plain copy of its boxes.
struct CheckedGrid {
  CheckedGrid(double cell, std::size_t bodies) : hash_grid(cell, bodies) {}

  void update_proxy(BodyId id, const Aabb& box) {
    hash_grid.update_proxy(id, box);
    boxes[id] = box;
  }
  /// Whether the grid reports each overlapping box once, and no other.
  bool is_right_about(BodyId id) {
    std::vector<BodyId> truth;
    for (const auto& [other, box] : boxes)
      if (other != id && overlap(boxes[id], box)) truth.push_back(other);
    overlaps += truth.size();
    return hash_grid.box(id) == boxes[id] && sorted_neighbours(hash_grid, id) == truth;
  }
  bool is_right() {
    return std::all_of(boxes.begin(), boxes.end(),
                       [this](const auto& checked) { return is_right_about(checked.first); });
  }

  HashGrid hash_grid;
  std::map<BodyId, Aabb> boxes;
  std::size_t overlaps = 0;
};

Aabb moved(const Aabb& box, const Vec3& by) { return {box.lo + by, box.hi + by}; }

/// A box about as long as the cells of some level, with its corners on or next to cell borders.
Aabb on_border(Dice& dice) {
  const double side = std::ldexp(1, dice.between(-3, 3));
  const auto grain = [&] { return 1 + dice.between(-1, 1) * 0x1p-52; };
  const Vec3 lo = side * dice.lattice(4) * grain();
  return {lo, lo + side * grain() * Vec3(1, dice.between(0, 1), dice.unit())};
}

TEST_CASE("tiling: near are those whose boxes meet, frame after frame") {
  constexpr BodyId bodies = 160;
  for (const tests::World world : tests::worlds) {
    for (const double cell : {0.01, 0.4, 30.0}) {
      CAPTURE(static_cast<int>(world), cell);
      Dice dice(7);
      CheckedGrid checked(cell, bodies);
      for (BodyId id = 0; id < bodies; ++id) {
        checked.update_proxy(id, tests::box_in(world, dice));
        REQUIRE(checked.is_right_about(id));
      }
      for (int frame = 0; frame < 6; ++frame) {
        for (BodyId id = 0; id < bodies; ++id) {
          const int kind = dice.between(0, 3);
          if (kind == 0) checked.update_proxy(id, tests::box_in(world, dice));
          if (kind == 1) checked.update_proxy(id, tests::stepped(world, checked.boxes[id], dice));
          if (kind == 2) checked.update_proxy(id, checked.boxes[id]);
        }
        REQUIRE(checked.is_right());
      }
      CHECK(checked.overlaps > 0);
    }
  }
}

TEST_CASE("tiling: a cell has room for any number, and they leave it in any order") {
  constexpr BodyId bodies = 64;
  Dice dice(3);
  CheckedGrid checked(1, bodies);
  std::vector<BodyId> order;
  for (BodyId id = 0; id < bodies; ++id) {
    order.push_back(id);
    checked.update_proxy(
        id, moved({Vec3::Zero(), Vec3::Constant(0.25 + id * 0x1p-10)}, dice.in_cube() / 4 + Vec3::Constant(0.5)));
  }
  REQUIRE(checked.is_right());
  for (const double away : {6.0, 3.0, -9.0}) {
    for (std::size_t left = order.size(); left > 0; --left) {
      std::swap(order[left - 1], order[static_cast<std::size_t>(dice.between(0, static_cast<int>(left) - 1))]);
      const BodyId id = order[left - 1];
      checked.update_proxy(id, moved(checked.boxes[id], Vec3(away, 0, 0)));
      CAPTURE(away, left);
      REQUIRE(checked.is_right());
    }
  }
}

TEST_CASE("tiling: specks, bodies and floors meet across the levels") {
  constexpr BodyId bodies = 240;
  Dice dice(5);
  CheckedGrid checked(1, bodies);
  const auto box = [&](BodyId id) -> Aabb {
    const double size = id % 3 == 0 ? 0x1p-8 : id % 3 == 1 ? 1 : id % 24 == 2 ? std::ldexp(1, dice.between(4, 60)) : 3;
    const Vec3 lo = 4 * dice.in_cube() - dice.unit() * Vec3::Constant(size);
    return {lo, lo + size * Vec3(1, 0.5, dice.unit())};
  };
  for (BodyId id = 0; id < bodies; ++id) checked.update_proxy(id, box(id));
  REQUIRE(checked.is_right());
  for (int frame = 0; frame < 10; ++frame) {  // the smallest boxes become the largest ones, and the reverse
    for (BodyId id = 0; id < bodies; ++id)
      if (dice.between(0, 2) == 0) checked.update_proxy(id, box(static_cast<BodyId>(dice.between(0, bodies - 1))));
    CAPTURE(frame);
    REQUIRE(checked.is_right());
  }
}

TEST_CASE("tiling: boxes that end where cells do, far from the origin and near it") {
  constexpr BodyId bodies = 200;
  for (const double far : {0.0, 1e3, -0x1p40, 0x1p51}) {
    CAPTURE(far);
    Dice dice(11);
    CheckedGrid checked(1, bodies);
    for (int frame = 0; frame < 6; ++frame) {
      for (BodyId id = 0; id < bodies; ++id) checked.update_proxy(id, moved(on_border(dice), Vec3::Constant(far)));
      REQUIRE(checked.is_right());
    }
  }
}

}  // namespace
}  // namespace touchstone::fast::simulation
