// How fast exact truth is. CPU time; run it several times on a busy machine.
#include <benchmark/benchmark.h>

#include <vector>

#include "reference/agreement.h"
#include "reference/distance.h"
#include "reference/penetration.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::tests {
namespace {

Quaternion random_quaternion(Dice& dice) {
  return {dice.around_zero(), dice.around_zero(), dice.around_zero(), dice.around_zero()};
}

/// Random hulls of `vertices` points in random poses, centres `reach` radii apart.
std::vector<Scene> round_pairs(int vertices, double reach) {
  Dice dice(1);
  std::vector<Scene> scenes;
  for (int i = 0; i < 64; ++i) {
    const Vec3 away = reach * dice.in_cube().normalized();
    scenes.push_back(pair_of({{round_hull(dice, vertices), away, random_quaternion(dice)},
                              {round_hull(dice, vertices), Vec3::Zero(), random_quaternion(dice)}}));
  }
  return scenes;
}

std::vector<Scene> hard_pairs(int first_family, int last_family) {
  Dice dice(2);
  std::vector<Scene> scenes;
  for (int family = first_family; family <= last_family; ++family) {
    for (int i = 0; i < 100; ++i) scenes.push_back(hard_pair(family, dice));
  }
  return scenes;
}

template <class Ask>
void ask_all(benchmark::State& state, const std::vector<Scene>& scenes, Ask ask) {
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ask(scenes[next]));
    next = (next + 1) % scenes.size();
  }
  state.SetItemsProcessed(state.iterations());
}

void distance_generic(benchmark::State& state) {
  ask_all(state, round_pairs(static_cast<int>(state.range(0)), 2.5),
          [](const Scene& s) { return reference::distance(s); });
}
BENCHMARK(distance_generic)->Arg(4)->Arg(8)->Arg(20)->Arg(50)->Arg(200)->Unit(benchmark::kMicrosecond);

void distance_overlapping(benchmark::State& state) {
  ask_all(state, round_pairs(static_cast<int>(state.range(0)), 1.0),
          [](const Scene& s) { return reference::distance(s); });
}
BENCHMARK(distance_overlapping)->Arg(20)->Arg(50)->Unit(benchmark::kMicrosecond);

void distance_hard(benchmark::State& state) {
  ask_all(state, hard_pairs(0, hard_families - 1), [](const Scene& s) { return reference::distance(s); });
}
BENCHMARK(distance_hard)->Iterations(hard_families * 100)->Unit(benchmark::kMicrosecond);

void distance_of_hard_family(benchmark::State& state) {
  const int family = static_cast<int>(state.range(0));
  ask_all(state, hard_pairs(family, family), [](const Scene& s) { return reference::distance(s); });
}
BENCHMARK(distance_of_hard_family)->DenseRange(0, hard_families - 1)->Unit(benchmark::kMicrosecond);

void three_routes_agree(benchmark::State& state) {
  const int family = static_cast<int>(state.range(0));
  ask_all(state, hard_pairs(family, family), [](const Scene& s) { return reference::disagreement(s); });
}
BENCHMARK(three_routes_agree)->DenseRange(0, hard_families - 1)->Iterations(100)->Unit(benchmark::kMicrosecond);

void depth_by_gauss_map(benchmark::State& state) {
  ask_all(state, round_pairs(static_cast<int>(state.range(0)), 1.0),
          [](const Scene& s) { return reference::penetration(s); });
}
BENCHMARK(depth_by_gauss_map)->Arg(8)->Arg(20)->Arg(50)->Arg(200)->Arg(600)->Unit(benchmark::kMicrosecond);

void depth_by_minkowski_hull(benchmark::State& state) {
  ask_all(state, round_pairs(static_cast<int>(state.range(0)), 1.0),
          [](const Scene& s) { return reference::penetration(s, reference::DepthRoute::minkowski_hull); });
}
BENCHMARK(depth_by_minkowski_hull)->Arg(8)->Arg(20)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace touchstone::tests

BENCHMARK_MAIN();
