// Tests the algorithms, not only their results: swaps, insertions, allocations.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/broad_phase/hierarchical_hash.h"
#include "fast/broad_phase/strategies.h"
#include "fast/broad_phase/sweep_and_prune.h"
#include "fast/broad_phase/wrapped_grid.h"
#include "tests/catch.h"
#include "tests/fast/allocations.h"
#include "tests/fast/broad_phase/sequence.h"

namespace touchstone::fast {
namespace {

using tests::Dice;
using tests::World;

/// The end points of one axis in their last order, and the number of inversions that sorting them again must undo.
class EndPoints {
 public:
  explicit EndPoints(int axis) : axis_(axis) {}

  std::uint64_t inversions(const std::map<BodyId, Aabb>& boxes) {
    for (const auto& [id, box] : boxes) {
      if (std::none_of(order_.begin(), order_.end(), [id = id](const Point& p) { return p.body == id; })) {
        order_.push_back({0, id, false});
        order_.push_back({0, id, true});
      }
    }
    // The end points of a removed body wait behind all others, each at a place of its own.
    for (Point& p : order_) {
      const auto box = boxes.find(p.body);
      p.value = box == boxes.end() ? 1e302 * (1 + p.body) : p.is_end ? box->second.hi[axis_] : box->second.lo[axis_];
    }
    const std::uint64_t count = merge_sort(0, order_.size());
    order_.erase(std::remove_if(order_.begin(), order_.end(), [](const Point& p) { return p.value > 1e301; }),
                 order_.end());
    return count;
  }

 private:
  struct Point {
    double value;
    BodyId body;
    bool is_end;
  };
  static bool less(const Point& x, const Point& y) {
    return x.value < y.value || (x.value == y.value && !x.is_end && y.is_end);
  }

  std::uint64_t merge_sort(std::size_t first, std::size_t last) {
    if (last - first < 2) return 0;
    const std::size_t middle = (first + last) / 2;
    std::uint64_t count = merge_sort(first, middle) + merge_sort(middle, last);
    std::vector<Point> merged;
    std::size_t i = first;
    std::size_t j = middle;
    while (i < middle || j < last) {
      if (j == last || (i < middle && !less(order_[j], order_[i]))) {
        merged.push_back(order_[i++]);
      } else {
        merged.push_back(order_[j++]);
        count += middle - i;  // all that are left of the first half precede it
      }
    }
    std::copy(merged.begin(), merged.end(), order_.begin() + static_cast<std::ptrdiff_t>(first));
    return count;
  }

  int axis_;
  std::vector<Point> order_;
};

TEST_CASE("sweep and prune: swaps are the inversions of the three lists, a still frame has none") {
  for (const World world : tests::worlds) {
    Dice dice(71);
    for (int round = 0; round < 10; ++round) {
      SweepAndPrune sweep;
      std::map<BodyId, Aabb> boxes;
      EndPoints x(0);
      EndPoints y(1);
      EndPoints z(2);
      for (int frame = 0; frame < 20; ++frame) {
        for (BodyId id = 0; id < 40; ++id) {
          const bool there = boxes.count(id) != 0;
          const int what = dice.between(0, 9);
          if (!there && what < 5) sweep.insert(id, boxes[id] = tests::box_in(world, dice));
          if (there && what == 0) {
            sweep.remove(id);
            boxes.erase(id);
          }
          if (there && what > 2) sweep.move(id, boxes[id] = tests::stepped(world, boxes[id], dice));
        }
        sweep.update();
        REQUIRE(sweep.swaps() == x.inversions(boxes) + y.inversions(boxes) + z.inversions(boxes));
        for (const auto& [id, box] : boxes) {
          sweep.move(id, tests::stepped(world, box, dice));
          sweep.move(id, box);  // back before the frame ends
        }
        sweep.update();
        REQUIRE(sweep.swaps() == 0);
      }
    }
  }
}

TEST_CASE("hierarchical hash: at most 8 (1 + ceil log2 R) entries a body") {
  Dice dice(81);
  for (const int octaves : {0, 1, 3, 10, 20, 29}) {
    for (int round = 0; round < 20; ++round) {
      HierarchicalHash hash;
      double least = std::numeric_limits<double>::infinity();
      double greatest = 0;
      constexpr BodyId bodies = 200;
      for (BodyId id = 0; id < bodies; ++id) {
        const double size = std::exp2(octaves * dice.unit());
        const Vec3 lo = 1000 * dice.in_cube();
        const Aabb box{lo, lo + Vec3(size, size * dice.unit(), size * dice.unit())};
        least = std::min(least, (box.hi - box.lo).maxCoeff());
        greatest = std::max(greatest, (box.hi - box.lo).maxCoeff());
        hash.insert(id, box);
      }
      hash.update();
      CHECK(static_cast<double>(hash.entries()) <= 8 * (1 + std::ceil(std::log2(greatest / least))) * bodies);
    }
  }
}

/// Bodies that alternate between two frames, so that both frames have occurred before.
TEST_CASE("broad phase: a steady frame allocates nothing") {
  for (const Strategy& strategy : strategies()) {
    Dice dice(91);
    const auto on_trial = strategy.make();
    std::vector<Aabb> here;
    std::vector<Aabb> there;
    for (BodyId id = 0; id < 300; ++id) {
      here.push_back(tests::box_in(World::spread, dice));
      there.push_back(tests::stepped(World::spread, here.back(), dice));
      on_trial->insert(id, here.back());
    }
    on_trial->update();
    const auto swing = [&](BodyId step) {
      for (const auto* boxes : {&there, &here}) {
        for (BodyId id = 0; id < 300; id += step) on_trial->move(id, (*boxes)[id]);
        on_trial->update();
      }
    };
    for (const BodyId step : {BodyId{1}, BodyId{30}}) {
      for (int i = 0; i < 100; ++i) swing(step);
      const std::size_t before = tests::allocations();
      for (int i = 0; i < 100; ++i) swing(step);
      const std::size_t in_steady_frames = tests::allocations() - before;
      INFO(strategy.name << ", every " << step);
      CHECK(in_steady_frames == 0);
    }
  }
}

/// Bodies of radius 1 that fill some per cent of their cube, inserted one by one, then moving.
TEST_CASE("wrapped grid: at most 200 bytes a body and 16 a pair") {
  for (const BodyId bodies : {BodyId{3000}, BodyId{20000}}) {
    for (const double room : {250.0, 25.0}) {
      Dice dice(95);
      std::vector<Aabb> boxes;
      const double side = std::cbrt(room * bodies);
      for (BodyId id = 0; id < bodies; ++id) {
        const Vec3 lo = side / 2 * dice.in_cube();
        boxes.push_back({lo, lo + Vec3(2, 2, 2)});
      }
      const std::size_t before = tests::bytes_held();
      WrappedGrid grid;
      for (BodyId id = 0; id < bodies; ++id) grid.insert(id, boxes[id]);
      grid.update();
      for (int frame = 0; frame < 20; ++frame) {
        for (BodyId id = 0; id < bodies; ++id) {
          const Vec3 by = 0.1 * std::cos(id) * Vec3(1, std::sin(id), 0.5);
          boxes[id] = {boxes[id].lo + by, boxes[id].hi + by};
          grid.move(id, boxes[id]);
        }
        grid.update();
      }
      const double bytes = static_cast<double>(tests::bytes_held() - before);
      INFO(bodies << " bodies, " << grid.pairs().size() << " pairs, " << bytes << " bytes");
      CHECK(bytes <= 200.0 * bodies + 16.0 * static_cast<double>(grid.pairs().size()));
    }
  }
}

/// Counts the frames in which something moved.
class CountedFrames : public BroadPhase {
 public:
  int frames = 0;

 private:
  void refresh() override { ++frames; }
};

TEST_CASE("broad phase: a body whose box is announced again unchanged did not move") {
  CountedFrames broad_phase;
  const Aabb box{Vec3(0, -1, 2), Vec3(1, 0, 3)};
  broad_phase.insert(3, box);
  broad_phase.update();
  REQUIRE(broad_phase.frames == 1);
  broad_phase.move(3, box);
  broad_phase.update();
  CHECK(broad_phase.frames == 1);
  for (int axis = 0; axis < 3; ++axis) {
    Aabb lower = box, higher = box;
    lower.lo[axis] -= 1;
    higher.hi[axis] += 1;
    for (const Aabb& moved : {lower, box, higher, box}) {
      const int before = broad_phase.frames;
      broad_phase.move(3, moved);
      broad_phase.update();
      CHECK(broad_phase.frames == before + 1);
    }
  }
}

}  // namespace
}  // namespace touchstone::fast
