// A collider over many frames: each frame's near pairs are exactly the true ones, whatever is inserted and removed.
#include "fast/collider.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fast/broad_phase/strategies.h"
#include "model/input_error.h"
#include "reference/distance.h"
#include "tests/catch.h"
#include "tests/fast/allocations.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast {
namespace {

using tests::Dice;

struct MovingBody {
  Body body;
  Vec3 velocity;
  Quaternion spin;
};

Quaternion times(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion unit(const Quaternion& q) {
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

Shape some_shape(Dice& dice, int kind) {
  if (kind == 0) return Sphere{0.75};
  if (kind == 1) return Box{dice.cell(1, 2) / 2};
  if (kind == 2) return tests::round_hull(dice, 12);
  const Vec3 offset = dice.in_cube();
  return Compound{{{Pose{offset, {}}, Box{Vec3(0.5, 0.25, 1)}}, {Pose{-offset, {1, 1, 0, 0}}, Sphere{0.5}}}};
}

std::vector<MovingBody> crowd(Dice& dice, int count, double room) {
  std::vector<MovingBody> moving_bodies;
  for (int i = 0; i < count; ++i) {
    const Shape shape = some_shape(dice, i % 4);
    const Vec3 place = room * dice.in_cube();
    const Vec3 velocity = 0.1 * dice.in_cube();
    moving_bodies.push_back({tests::body(shape, place, tests::integer_quaternion(dice)), velocity,
                             unit({12, dice.around_zero(), dice.around_zero(), dice.around_zero()})});
  }
  return moving_bodies;
}

/// Moves on, and back from the walls of a cube.
void fly(MovingBody& moving_body, double room) {
  Pose& X = moving_body.body.X_WB;
  X.p_WB += moving_body.velocity;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(X.p_WB[i]) > room) moving_body.velocity[i] = std::copysign(moving_body.velocity[i], -X.p_WB[i]);
  }
  X.q_WB = unit(times(moving_body.spin, X.q_WB));
}

/// Compares every pair of the present bodies, by the reference's distance, with the collider's near pairs.
void check(const Collider& collider, const std::vector<MovingBody>& moving_bodies, const std::vector<bool>& present,
           double margin) {
  std::map<std::pair<BodyId, BodyId>, const lin_canny::Proximity*> near;
  for (const NearPair& pair : collider.pairs()) near[{pair.bodies.a, pair.bodies.b}] = &pair.nearest.proximity;
  REQUIRE(near.size() == collider.pairs().size());
  std::size_t expected = 0;
  for (std::size_t i = 0; i < moving_bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < moving_bodies.size(); ++j) {
      if (!present[i] || !present[j]) continue;
      const reference::DistanceTruth truth =
          reference::distance(tests::pair(moving_bodies[i].body, moving_bodies[j].body));
      const auto found = near.find({static_cast<BodyId>(i), static_cast<BodyId>(j)});
      if (found == near.end()) {
        REQUIRE(truth.distance.lo > margin);
        continue;
      }
      ++expected;
      REQUIRE(found->second->verdict == truth.verdict);
      REQUIRE(found->second->enclosure.lo <= truth.distance.lo);
      REQUIRE(found->second->enclosure.hi >= truth.distance.hi);
    }
  }
  REQUIRE(near.size() == expected);
}

TEST_CASE("a thousand frames: no pair is missed, each has its distance") {
  Dice dice(31);
  constexpr double room = 2.5;
  constexpr double margin = 0.25;
  std::vector<MovingBody> moving_bodies = crowd(dice, 8, room);
  std::vector<bool> present(moving_bodies.size(), true);
  Collider collider(find_strategy("sweep_and_prune").make(), margin);
  for (BodyId id = 0; id < moving_bodies.size(); ++id)
    collider.insert(id, moving_bodies[id].body.shape, moving_bodies[id].body.X_WB);
  std::size_t near = 0;
  for (int frame = 0; frame < 1000; ++frame) {
    for (BodyId id = 0; id < moving_bodies.size(); ++id) {
      fly(moving_bodies[id], room);
      if (present[id]) collider.move(id, moving_bodies[id].body.X_WB);
    }
    // Now and then one body is removed, one is inserted, and one is replaced by another.
    const auto id = static_cast<BodyId>(dice.between(0, 7));
    if (frame % 10 == 3) {
      if (present[id]) collider.remove(id);
      if (!present[id]) collider.insert(id, moving_bodies[id].body.shape, moving_bodies[id].body.X_WB);
      present[id] = !present[id];
    }
    if (frame % 10 == 7 && present[id]) {
      collider.remove(id);
      moving_bodies[id].body.shape = some_shape(dice, dice.between(0, 3));
      collider.insert(id, moving_bodies[id].body.shape, moving_bodies[id].body.X_WB);
    }
    collider.update();
    near += collider.pairs().size();
    if (frame % 2 == 0) check(collider, moving_bodies, present, margin);
  }
  CHECK(near > 1000);
}

TEST_CASE("whichever broad phase prunes, the same pairs and answers") {
  Dice dice(32);
  std::vector<MovingBody> moving_bodies = crowd(dice, 20, 4);
  std::vector<Collider> colliders;
  for (const Strategy& strategy : strategies()) colliders.emplace_back(strategy.make(), 0.5);
  for (int frame = 0; frame < 30; ++frame) {
    std::vector<std::map<std::pair<BodyId, BodyId>, double>> said;
    for (Collider& collider : colliders) {
      for (BodyId id = 0; id < moving_bodies.size(); ++id) {
        if (frame == 0) collider.insert(id, moving_bodies[id].body.shape, moving_bodies[id].body.X_WB);
        if (frame > 0) collider.move(id, moving_bodies[id].body.X_WB);
      }
      collider.update();
      said.emplace_back();
      for (const NearPair& pair : collider.pairs()) {
        said.back()[{pair.bodies.a, pair.bodies.b}] = pair.nearest.proximity.distance;
      }
    }
    for (const auto& other : said) REQUIRE(other == said.front());
    for (MovingBody& moving_body : moving_bodies) fly(moving_body, 4);
  }
}

TEST_CASE("a frame that follows the same pairs asks for no memory") {
  Dice dice(33);
  Collider collider(find_strategy("sweep_and_prune").make(), 2);
  std::vector<Pose> poses;
  for (BodyId id = 0; id < 27; ++id) {
    poses.push_back({3 * Vec3(id % 3, id / 3 % 3, id / 9), tests::integer_quaternion(dice)});
    collider.insert(id, tests::round_hull(dice, 20), poses.back());
  }
  for (int frame = 0; frame < 3; ++frame) collider.update();
  const std::size_t pairs = collider.pairs().size();
  CHECK(pairs > 27);
  std::size_t asked = 0;
  for (int frame = 0; frame < 50; ++frame) {
    for (BodyId id = 0; id < poses.size(); ++id) poses[id].q_WB.w += 0.01;
    const std::size_t before = tests::allocations();
    for (BodyId id = 0; id < poses.size(); ++id) collider.move(id, poses[id]);
    collider.update();
    asked += tests::allocations() - before;
    REQUIRE(collider.pairs().size() == pairs);
  }
  CHECK(asked == 0);
}

TEST_CASE("who is not there cannot move or go, what is no solid cannot come") {
  Collider collider(find_strategy("sweep_and_prune").make());
  CHECK_THROWS_AS(collider.move(3, {}), InputError);
  CHECK_THROWS_AS(collider.remove(3), InputError);
  CHECK_THROWS_AS(collider.insert(0, Polytope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}}, {}), InputError);
  collider.insert(0, Sphere{1}, {});
  CHECK_THROWS_AS(collider.insert(0, Sphere{2}, {}), InputError);
  CHECK_THROWS_AS(collider.move(0, {Vec3(1e308, 0, 0), {}}), InputError);
  collider.insert(1, Sphere{1}, {Vec3(2, 0, 0), {}});
  CHECK_THROWS_AS(collider.move(1, {Vec3(1e308, 0, 0), {}}), InputError);
  collider.update();
  REQUIRE(collider.pairs().size() == 1);
  CHECK(collider.pairs()[0].nearest.proximity.verdict == Verdict::touching);
  collider.remove(1);
  CHECK_THROWS_AS(collider.move(1, {}), InputError);
  collider.update();
  CHECK(collider.pairs().empty());
}

}  // namespace
}  // namespace touchstone::fast
