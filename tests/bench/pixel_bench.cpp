// Tests at pixel resolution, as CSV: the overlap of two masks, compared with a plain read of the same bytes; and how
// often sampling misses bodies that overlap, for several pixel sizes, with its cost and that of the exact distance.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "fast/distance.h"
#include "fast/pixel.h"
#include "fast/pixel/bit_mask.h"
#include "tests/bench/command_line.h"

namespace {

using namespace touchstone;
using Clock = std::chrono::steady_clock;

std::uint64_t next_bits(std::uint64_t& state) {  // SplitMix64
  std::uint64_t z = state += 0x9e3779b97f4a7c15U;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
  z = (z ^ z >> 27) * 0x94d049bb133111ebU;
  return z ^ z >> 31;
}

double unit(std::uint64_t& state) { return static_cast<double>(next_bits(state) >> 11) * 0x1p-53; }

/// The minimum of several runs, in ns.
template <class F>
double nanoseconds(int runs, int times, F&& f) {
  double least = 1e300;
  for (int run = 0; run < runs; ++run) {
    const auto start = Clock::now();
    for (int i = 0; i < times; ++i) f(i);
    least = std::min(least, std::chrono::duration<double, std::nano>(Clock::now() - start).count() / times);
  }
  return least;
}

/// The cost of a loop that only reads. It has four sums, so that no addition waits for another.
std::uint64_t read_all(const fast::pixel::BitMask& mask) {
  std::uint64_t sums[4] = {};
  for (int j = 0; j < mask.rows(); ++j) {
    const std::uint64_t* const row = mask.row(j);
    for (int w = 0; w + 4 <= mask.words(); w += 4) {
      for (int k = 0; k < 4; ++k) sums[k] += row[w + k];
    }
  }
  return sums[0] + sums[1] + sums[2] + sums[3];
}

constexpr int side_of_a_mask = 64;  ///< multiple of the requested size

void masks(int size, int rounds) {
  const int side = side_of_a_mask * size;
  std::uint64_t state = 1;
  fast::pixel::BitMask A(side, side);
  fast::pixel::BitMask B(side, side);
  for (fast::pixel::BitMask* mask : {&A, &B}) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        if ((next_bits(state) & 1U) != 0) mask->set(i, j);
      }
    }
  }
  const int times = std::max(1, 64 * 1024 * 1024 / (side * side));
  std::uint64_t sink = 0;
  const double read = nanoseconds(rounds, times, [&](int) {
    sink += read_all(A) + read_all(B);
    asm volatile("" : "+r"(sink) : : "memory");
  });
  std::printf("masks,%d,plain read,peer,%.1f,,,\n", side, read);
  for (const auto& [x, y] : {std::pair(0, 0), {64, 1}, {5, -3}}) {
    const double laid = nanoseconds(rounds, times, [&, dx = x, dy = y](int) {
      sink += static_cast<std::uint64_t>(fast::pixel::overlap(A, B, dx, dy).count);
      asm volatile("" : "+r"(sink) : : "memory");
    });
    std::printf("masks,%d,overlap at (%d %d),ours,%.1f,,,\n", side, x, y, laid);
  }
}

Polytope prism(int corners) {
  Polytope made;
  std::vector<int> bottom;
  std::vector<int> top;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * 3.14159265358979 * k / corners;
    for (const double z : {-0.5, 0.5}) made.vertices.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle), z);
    bottom.insert(bottom.begin(), 2 * k);
    top.push_back(2 * k + 1);
    const int next = (k + 1) % corners;
    made.faces.push_back({2 * k, 2 * next, 2 * next + 1, 2 * k + 1});
  }
  made.faces.push_back(bottom);
  made.faces.push_back(top);
  return made;
}

Shape shape_of(const std::string& workload) {
  if (workload == "boxes") return Box{Vec3(0.5, 0.3, 0.5)};
  return prism(workload == "triangles" ? 3 : 16);
}

/// Rotated about z only: prisms overlap exactly if their projections do, so the result follows the law of plane
/// figures.
Body some_body(const Shape& shape, std::uint64_t& state) {
  Body body;
  body.shape = shape;
  const double x = 2.4 * unit(state) - 1.2;
  body.X_WB.p_WB = Vec3(x, 2.4 * unit(state) - 1.2, 0);
  const double half = 3.14159265358979 * unit(state);
  body.X_WB.q_WB = {std::cos(half), 0, 0, std::sin(half)};
  return body;
}

bool any(const Mask& mask) {
  return std::ranges::any_of(mask, [](const std::string& row) { return row.find('1') != std::string::npos; });
}

constexpr int pairs = 1000;

void misses(const std::string& workload, int fine) {
  std::uint64_t state = 7;
  std::vector<Scene> scenes;
  const Shape shape = shape_of(workload);
  while (static_cast<int>(scenes.size()) < pairs) {
    Scene scene;
    scene.bodies = {some_body(shape, state), some_body(shape, state)};
    scene.raster = Raster{-2, -2, 1.0 / fine, 4 * fine, 4 * fine, 0, 0};
    if (fast::distance(scene).verdict == Verdict::overlapping) scenes.push_back(scene);
  }
  int missed = 0;
  const double sampled = nanoseconds(
      1, pairs, [&](int i) { missed += !any(fast::pixels(scenes[static_cast<std::size_t>(i)]).meet_sampled); });
  const double exact = nanoseconds(1, pairs, [&](int i) { fast::distance(scenes[static_cast<std::size_t>(i)]); });
  const double share = static_cast<double>(missed) / pairs;
  std::printf("%s,%d,sampled pixels,ours,%.0f,%.4g,%.4g,\n", workload.c_str(), fine, sampled, share, share);
  std::printf("%s,%d,distance,other,%.0f,0,0,\n", workload.c_str(), fine, exact);
}

void run(const bench::Options& options) {
  std::printf("workload,size,name,whose,ns,median_error,worst_error,left_out\n");
  for (const std::string& workload : options.workloads) {
    for (const int size : options.sizes) {
      workload == "masks" ? masks(size, options.rounds) : misses(workload, size);
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> workloads{"masks", "boxes", "triangles", "16-gons"};
  return bench::run_comparison(argc, argv,
                               {"Tests at pixel resolution: masks, and what sampling misses.",
                                "pixels a metre; of masks, sides in words of 64",
                                {{4, 8, 16, 32, 64, 128}, workloads, 9},
                                workloads},
                               run);
}
