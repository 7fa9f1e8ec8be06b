// Each strategy against all pairs, after every frame of random sequences.
#include "fast/broad_phase/strategies.h"

#include <algorithm>
#include <limits>

#include "model/input_error.h"
#include "tests/catch.h"
#include "tests/fast/broad_phase/sequence.h"

namespace touchstone::fast {
namespace {

using tests::Dice;
using tests::World;
using Pairs = std::vector<BodyPair>;

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs difference(const Pairs& a, const Pairs& b) {
  Pairs only_a;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only_a));
  return only_a;
}

/// A broad phase and, in parallel, the boxes that it was given.
struct Life {
  explicit Life(const Strategy& strategy) : on_trial(strategy.make()) {}

  void insert(BodyId id, const Aabb& box) {
    on_trial->insert(id, box);
    boxes[id] = box;
  }
  void move(BodyId id, const Aabb& box) {
    on_trial->move(id, box);
    boxes[id] = box;
  }
  void remove(BodyId id) {
    on_trial->remove(id);
    boxes.erase(id);
  }

  bool end_frame() {
    on_trial->update();
    const Pairs truth = tests::true_pairs(boxes);
    const bool right = sorted(on_trial->pairs()) == truth && sorted(on_trial->begun()) == difference(truth, before) &&
                       sorted(on_trial->ended()) == difference(before, truth);
    before = truth;
    return right;
  }

  std::unique_ptr<BroadPhase> on_trial;
  std::map<BodyId, Aabb> boxes;
  Pairs before;
};

/// One frame: 0 nothing moves, 1 a few steps, 2 all step, 3 teleports, 4 insertions, 5 removals, 6 a body that is
/// removed and inserted again within the frame, and one that is inserted and removed.
void live(Life& life, World world, int kind, BodyId bodies, Dice& dice) {
  for (BodyId id = 0; id < bodies; ++id) {
    const bool chosen = dice.between(0, 5) == 0;
    const auto body = life.boxes.find(id);
    if (body == life.boxes.end()) {
      if (kind == 4 && chosen) life.insert(id, tests::box_in(world, dice));
      if (kind == 6 && chosen) {
        life.insert(id, tests::box_in(world, dice));
        life.remove(id);
      }
    } else if (kind == 2 || (kind == 1 && chosen)) {
      life.move(id, tests::stepped(world, body->second, dice));
    } else if (kind == 3 && chosen) {
      life.move(id, tests::box_in(world, dice));
    } else if (kind == 5 && chosen) {
      life.remove(id);
    } else if (kind == 6 && chosen) {
      const Aabb box = body->second;
      life.remove(id);
      life.insert(id, dice.between(0, 1) == 0 ? box : tests::box_in(world, dice));
    }
  }
}

TEST_CASE("broad phase: pairs, begun and ended are those of all pairs after every frame of random lives") {
  for (const Strategy& strategy : strategies()) {
    for (const World world : tests::worlds) {
      Dice dice(21 + static_cast<std::uint64_t>(world));
      for (int round = 0; round < 40; ++round) {
        Life life(strategy);
        const BodyId bodies = static_cast<BodyId>(dice.between(2, 60));
        live(life, world, 4, bodies, dice);
        for (int frame = 0; frame < 30; ++frame) {
          INFO(strategy.name << ", world " << static_cast<int>(world) << ", round " << round << ", frame " << frame);
          REQUIRE(life.end_frame());
          live(life, world, dice.between(0, 6), bodies, dice);
        }
      }
    }
  }
}

TEST_CASE("broad phase: many bodies, long lives") {
  for (const Strategy& strategy : strategies()) {
    for (const World world : {World::spread, World::sizes, World::cluster, World::flat}) {
      Dice dice(31);
      Life life(strategy);
      const auto small = [&] {
        Aabb box = tests::box_in(world, dice);
        box.hi = box.lo + 0.25 * (box.hi - box.lo);
        return box;
      };
      for (BodyId id = 0; id < 700; ++id) life.insert(id, small());
      for (int frame = 0; frame < 40; ++frame) {
        INFO(strategy.name << ", world " << static_cast<int>(world) << ", frame " << frame);
        REQUIRE(life.end_frame());
        // Few, then more, then all: both branches of the incremental strategies, and the switch between them.
        const int one_in = frame < 30 ? 50 : 2;
        for (BodyId id = 0; id < 700; ++id)
          if (dice.between(1, one_in) == 1)
            life.move(id, dice.between(0, 9) == 0 ? small() : tests::stepped(world, life.boxes.at(id), dice));
      }
    }
  }
}

/// Steps so short that a grid may keep its results for several frames, until many bodies leave their boxes at once.
TEST_CASE("broad phase: slow drift, and now and then a body that jumps, goes or comes") {
  for (const Strategy& strategy : strategies()) {
    for (const World world : {World::spread, World::sizes, World::cluster}) {
      Dice dice(35);
      Life life(strategy);
      std::vector<Vec3> velocity;
      for (BodyId id = 0; id < 250; ++id) {
        life.insert(id, tests::box_in(world, dice));
        velocity.push_back(0.01 * dice.unit() * dice.in_cube());
      }
      for (int frame = 0; frame < 60; ++frame) {
        INFO(strategy.name << ", world " << static_cast<int>(world) << ", frame " << frame);
        REQUIRE(life.end_frame());
        for (BodyId id = 0; id < 250; ++id) {
          const auto body = life.boxes.find(id);
          const int what = dice.between(0, 400);
          if (body == life.boxes.end()) {
            if (what < 40) life.insert(id, tests::box_in(world, dice));
          } else if (what == 0) {
            life.remove(id);
          } else if (what == 1) {
            life.move(id, tests::box_in(world, dice));
          } else if (id % 7 != 0) {
            life.move(id, {body->second.lo + velocity[id], body->second.hi + velocity[id]});
          }
        }
      }
    }
  }
}

TEST_CASE("broad phase: the same configuration reached by inserting and by moving gives the same pairs") {
  for (const Strategy& strategy : strategies()) {
    Dice dice(41);
    for (int round = 0; round < 100; ++round) {
      Life moved(strategy);
      Life inserted(strategy);
      for (BodyId id = 0; id < 20; ++id) moved.insert(id, tests::box_in(World::lattice, dice));
      moved.end_frame();
      for (BodyId id = 0; id < 20; ++id) {
        const Aabb box = tests::box_in(World::lattice, dice);
        moved.move(id, box);
        inserted.insert(id, box);
      }
      REQUIRE(moved.end_frame());
      REQUIRE(inserted.end_frame());
    }
  }
}

TEST_CASE("broad phase: the same calls give the same lists, order included") {
  for (const Strategy& strategy : strategies()) {
    Life one(strategy);
    Life two(strategy);
    for (Life* life : {&one, &two}) {
      Dice dice(51);
      live(*life, World::spread, 4, 200, dice);
      for (int frame = 0; frame < 10; ++frame) {
        life->end_frame();
        live(*life, World::spread, frame % 7, 200, dice);
      }
      life->end_frame();
    }
    CHECK(one.on_trial->pairs() == two.on_trial->pairs());
    CHECK(one.on_trial->begun() == two.on_trial->begun());
    CHECK(one.on_trial->ended() == two.on_trial->ended());
  }
}

TEST_CASE("broad phase: relabelled bodies and exchanged axes give the same pairs") {
  for (const Strategy& strategy : strategies()) {
    Dice dice(61);
    Life plain(strategy);
    Life turned(strategy);
    for (BodyId id = 0; id < 80; ++id) {
      const Aabb box = tests::box_in(World::flat, dice);
      plain.insert(id, box);
      turned.insert(79 - id, {Vec3(box.lo.z(), box.lo.x(), box.lo.y()), Vec3(box.hi.z(), box.hi.x(), box.hi.y())});
    }
    CHECK(plain.end_frame());
    CHECK(turned.end_frame());
    CHECK(plain.on_trial->pairs().size() == turned.on_trial->pairs().size());
  }
}

TEST_CASE("broad phase: bad input is refused and changes nothing") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Aabb good{Vec3::Zero(), Vec3::Ones()};
  for (const Strategy& strategy : strategies()) {
    Life life(strategy);
    CHECK(life.end_frame());
    life.insert(0, good);
    life.insert(3, good);
    CHECK(life.end_frame());
    BroadPhase& on_trial = *life.on_trial;
    for (const double bad : {nan, infinity, -infinity, 1e302, -1e302}) {
      for (int axis = 0; axis < 3; ++axis) {
        Aabb box = good;
        box.hi[axis] = bad;
        CHECK_THROWS_AS(on_trial.insert(1, box), InputError);
        CHECK_THROWS_AS(on_trial.move(0, box), InputError);
        box = good;
        box.lo[axis] = bad;
        CHECK_THROWS_AS(on_trial.insert(1, box), InputError);
        CHECK_THROWS_AS(on_trial.move(0, box), InputError);
      }
    }
    CHECK_THROWS_AS(on_trial.insert(1, {Vec3::Ones(), Vec3::Zero()}), InputError);
    CHECK_THROWS_AS(on_trial.insert(0, good), InputError);
    CHECK_THROWS_AS(on_trial.move(1, good), InputError);
    CHECK_THROWS_AS(on_trial.remove(1), InputError);
    CHECK_THROWS_AS(on_trial.remove(4000000000U), InputError);
    CHECK_THROWS_AS(on_trial.insert(1U << 24U, good), InputError);
    CHECK(life.end_frame());
    CHECK(on_trial.pairs() == Pairs{{0, 3}});
    life.remove(0);
    CHECK(life.end_frame());
    life.remove(3);
    CHECK(life.end_frame());
    life.insert(0, good);
    CHECK(life.end_frame());
  }
}

TEST_CASE("broad phase: coordinates of 1e300 and 1e-300 side by side") {
  for (const Strategy& strategy : strategies()) {
    Life life(strategy);
    BodyId id = 0;
    for (const double size : {1e300, 1e-300, 1.0, 0.0})
      for (const double sign : {1.0, -1.0}) {
        life.insert(id++, {Vec3::Constant(sign * size - size), Vec3::Constant(sign * size + size)});
        life.insert(id++, {Vec3::Constant(sign * 1e300), Vec3::Constant(sign * 1e300)});
      }
    INFO(strategy.name);
    CHECK(life.end_frame());
    for (BodyId i = 0; i < id; i += 3) life.move(i, {Vec3::Constant(-1e300), Vec3::Constant(-1e-300)});
    CHECK(life.end_frame());
  }
}

TEST_CASE("find_strategy: an unknown name is told the known ones") {
  CHECK(find_strategy("octree").name == "octree");
  CHECK_THROWS_WITH(find_strategy("quadtree"), Catch::Contains("wrapped_grid"));
}

}  // namespace
}  // namespace touchstone::fast
