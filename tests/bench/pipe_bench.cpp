// Queries per second through the pipe, compared with the same subject in process: the cost of writing, reading and
// waiting.
#include <benchmark/benchmark.h>

#include <cmath>

#include "oracle/process/pipe.h"
#include "oracle/subject.h"
#include "oracle/subjects/libccd/libccd.h"
#include "reference/validity.h"

namespace touchstone::oracle {
namespace {

/// Points on a spiral on the unit sphere: all of them are vertices of their hull.
Body round_body(int vertices, double x) {
  Polytope polytope;
  for (int i = 0; i < vertices; ++i) {
    const double z = 1 - (2 * i + 1.0) / vertices;
    const double radius = std::sqrt(1 - z * z);
    polytope.vertices.emplace_back(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), z);
  }
  Body body;
  body.shape = polytope;
  body.X_WB = {{x, 0.1, 0.2}, {1, 2, 3, 4.5}};
  return body;
}

Scene round_pair(int vertices) {
  Scene scene;
  scene.bodies = {round_body(vertices, 0), round_body(vertices, 2.5)};
  return reference::completed(scene);
}

void ask_new_scenes(benchmark::State& state, Subject& subject) {
  Scene scene = round_pair(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    scene.bodies[0].X_WB.p_WB.x() += 0x1p-30;
    benchmark::DoNotOptimize(subject.distance(scene));
  }
  state.SetItemsProcessed(state.iterations());
}

void pipe_new_scene(benchmark::State& state) { ask_new_scenes(state, *connect("libccd.gjk", TOUCHSTONE_SUBJECTS)); }

void in_process(benchmark::State& state) { ask_new_scenes(state, *subjects::make_libccd_gjk()); }

void pipe_same_scene(benchmark::State& state) {
  const auto subject = connect("libccd.gjk", TOUCHSTONE_SUBJECTS);
  const Scene scene = round_pair(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(subject->distance(scene));
  state.SetItemsProcessed(state.iterations());
}

void start_and_stop(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(connect("libccd.gjk", TOUCHSTONE_SUBJECTS));
}

// Two processes take part, and only the wall clock measures both.
BENCHMARK(pipe_new_scene)->Arg(4)->Arg(8)->Arg(20)->Arg(50)->UseRealTime();
BENCHMARK(pipe_same_scene)->Arg(4)->Arg(8)->Arg(20)->Arg(50)->UseRealTime();
BENCHMARK(in_process)->Arg(4)->Arg(8)->Arg(20)->Arg(50);
BENCHMARK(start_and_stop)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace touchstone::oracle

BENCHMARK_MAIN();
