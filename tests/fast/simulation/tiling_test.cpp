#include "fast/simulation/tiling.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/broad_phase/sequence.h"

namespace touchstone::fast::world {
namespace {

using tests::Dice;
using tests::World;

std::vector<BodyId> met(Tiling& tiling, BodyId id) {
  const std::span<const BodyId> near = tiling.near(id);
  std::vector<BodyId> ids(near.begin(), near.end());
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// A tiling and, beside it, what it has been told.
struct Filed {
  Filed(double cell, std::size_t bodies) : tiling(cell, bodies) {}

  void file(BodyId id, const Aabb& box) {
    tiling.file(id, box);
    boxes[id] = box;
  }
  /// Each box that it meets once, and no other.
  bool is_right_about(BodyId id) {
    std::vector<BodyId> truth;
    for (const auto& [other, box] : boxes)
      if (other != id && overlap(boxes[id], box)) truth.push_back(other);
    meetings += truth.size();
    return tiling.box(id) == boxes[id] && met(tiling, id) == truth;
  }
  bool is_right() {
    return std::all_of(boxes.begin(), boxes.end(), [this](const auto& filed) { return is_right_about(filed.first); });
  }

  Tiling tiling;
  std::map<BodyId, Aabb> boxes;
  std::size_t meetings = 0;
};

Aabb moved(const Aabb& box, const Vec3& by) { return {box.lo + by, box.hi + by}; }

/// As long as the cells of some level, or a little less or more, and on their borders or a little beside them.
Aabb on_border(Dice& dice) {
  const double side = std::ldexp(1, dice.between(-3, 3));
  const auto grain = [&] { return 1 + dice.between(-1, 1) * 0x1p-52; };
  const Vec3 lo = side * dice.lattice(4) * grain();
  return {lo, lo + side * grain() * Vec3(1, dice.between(0, 1), dice.unit())};
}

TEST_CASE("tiling: near are those whose boxes meet, frame after frame") {
  constexpr BodyId bodies = 160;
  for (const World world : tests::worlds) {
    for (const double cell : {0.01, 0.4, 30.0}) {
      CAPTURE(static_cast<int>(world), cell);
      Dice dice(7);
      Filed filed(cell, bodies);
      for (BodyId id = 0; id < bodies; ++id) {
        filed.file(id, tests::box_in(world, dice));
        REQUIRE(filed.is_right_about(id));
      }
      for (int frame = 0; frame < 6; ++frame) {
        for (BodyId id = 0; id < bodies; ++id) {
          const int kind = dice.between(0, 3);
          if (kind == 0) filed.file(id, tests::box_in(world, dice));
          if (kind == 1) filed.file(id, tests::stepped(world, filed.boxes[id], dice));
          if (kind == 2) filed.file(id, filed.boxes[id]);
        }
        REQUIRE(filed.is_right());
      }
      CHECK(filed.meetings > 0);
    }
  }
}

TEST_CASE("tiling: a cell has room for any number, and they leave it in any order") {
  constexpr BodyId bodies = 64;
  Dice dice(3);
  Filed filed(1, bodies);
  std::vector<BodyId> order;
  for (BodyId id = 0; id < bodies; ++id) {
    order.push_back(id);
    filed.file(id,
               moved({Vec3::Zero(), Vec3::Constant(0.25 + id * 0x1p-10)}, dice.in_cube() / 4 + Vec3::Constant(0.5)));
  }
  REQUIRE(filed.is_right());
  for (const double away : {6.0, 3.0, -9.0}) {
    for (std::size_t left = order.size(); left > 0; --left) {
      std::swap(order[left - 1], order[static_cast<std::size_t>(dice.between(0, static_cast<int>(left) - 1))]);
      const BodyId id = order[left - 1];
      filed.file(id, moved(filed.boxes[id], Vec3(away, 0, 0)));
      CAPTURE(away, left);
      REQUIRE(filed.is_right());
    }
  }
}

TEST_CASE("tiling: specks, bodies and floors meet across the levels") {
  constexpr BodyId bodies = 240;
  Dice dice(5);
  Filed filed(1, bodies);
  const auto box = [&](BodyId id) -> Aabb {
    const double size = id % 3 == 0 ? 0x1p-8 : id % 3 == 1 ? 1 : id % 24 == 2 ? std::ldexp(1, dice.between(4, 60)) : 3;
    const Vec3 lo = 4 * dice.in_cube() - dice.unit() * Vec3::Constant(size);
    return {lo, lo + size * Vec3(1, 0.5, dice.unit())};
  };
  for (BodyId id = 0; id < bodies; ++id) filed.file(id, box(id));
  REQUIRE(filed.is_right());
  for (int frame = 0; frame < 10; ++frame) {  // specks become floors, and floors specks
    for (BodyId id = 0; id < bodies; ++id)
      if (dice.between(0, 2) == 0) filed.file(id, box(static_cast<BodyId>(dice.between(0, bodies - 1))));
    CAPTURE(frame);
    REQUIRE(filed.is_right());
  }
}

TEST_CASE("tiling: boxes that end where cells do, far from the origin and near it") {
  constexpr BodyId bodies = 200;
  for (const double far : {0.0, 1e3, -0x1p40, 0x1p51}) {
    CAPTURE(far);
    Dice dice(11);
    Filed filed(1, bodies);
    for (int frame = 0; frame < 6; ++frame) {
      for (BodyId id = 0; id < bodies; ++id) filed.file(id, moved(on_border(dice), Vec3::Constant(far)));
      REQUIRE(filed.is_right());
    }
  }
}

}  // namespace
}  // namespace touchstone::fast::world
