// Speed of the exact reference, in CPU time. Run it several times on a busy machine.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "reference/agreement.h"
#include "reference/distance.h"
#include "reference/penetration.h"
#include "reference/time_of_impact.h"
#include "tests/reference/moving_scenes.h"

namespace touchstone::tests {
namespace {

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

/// Hulls that move towards each other. The counters report how many come into contact, and the median width of the
/// enclosures.
template <class Change>
void times_of_impact(benchmark::State& state, Change change) {
  Dice dice(3);
  std::vector<Scene> scenes;
  for (int i = 0; i < 64; ++i) scenes.push_back(change(ballistic_pair(dice, static_cast<int>(state.range(0)))));
  ask_all(state, scenes, [](const Scene& s) { return reference::time_of_impact(s); });
  std::vector<double> widths;
  for (const Scene& scene : scenes) {
    const reference::TimeOfImpactTruth truth = reference::time_of_impact(scene);
    if (truth.status == TimeOfImpact::Status::hit) widths.push_back(truth.time.hi - truth.time.lo);
  }
  std::ranges::sort(widths);
  state.counters["hits"] = static_cast<double>(widths.size());
  state.counters["width_median"] = widths[widths.size() / 2];
  state.counters["width_greatest"] = widths.back();
}

void time_of_impact_screws(benchmark::State& state) {
  times_of_impact(state, [](Scene scene) { return scene; });
}
BENCHMARK(time_of_impact_screws)->Arg(8)->Arg(20)->Arg(50)->Arg(100)->Unit(benchmark::kMicrosecond);

void time_of_impact_tops(benchmark::State& state) {
  times_of_impact(state, [](Scene scene) {
    for (Body& body : scene.bodies) std::get<MassProperties>(body.mass).I_BBcm_B = Vec3(1, 1, 1.5).asDiagonal();
    return scene;
  });
}
BENCHMARK(time_of_impact_tops)->Arg(20)->Unit(benchmark::kMicrosecond);

void time_of_impact_tumbling(benchmark::State& state) {
  times_of_impact(state, [](Scene scene) {
    for (Body& body : scene.bodies) body.mass = Density{};
    return scene;
  });
}
BENCHMARK(time_of_impact_tumbling)->Arg(20)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace touchstone::tests

BENCHMARK_MAIN();
