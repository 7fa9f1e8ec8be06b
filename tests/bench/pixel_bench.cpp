// Two measurements of tests at pixel resolution: masks laid over each other, against a plain read of the same bytes;
// and how often sampling misses bodies that overlap, by the size of a pixel, with what it costs. A table, then CSV.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "fast/distance.h"
#include "fast/pixel.h"
#include "fast/pixel/bit_mask.h"

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

/// The least of some runs, ns.
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

/// What a loop that only reads costs: four sums, so that no addition waits for another.
std::uint64_t read_all(const fast::pixels::BitMask& mask) {
  std::uint64_t sums[4] = {};
  for (int j = 0; j < mask.rows(); ++j) {
    const std::uint64_t* const row = mask.row(j);
    for (int w = 0; w + 4 <= mask.words(); w += 4) {
      for (int k = 0; k < 4; ++k) sums[k] += row[w + k];
    }
  }
  return sums[0] + sums[1] + sums[2] + sums[3];
}

void masks() {
  std::printf("masks laid over each other, half of the bits set\n%8s %10s %12s %12s %7s\n", "size", "shift",
              "overlap ns", "read ns", "ratio");
  for (const int size : {256, 1024, 4096, 16384}) {
    std::uint64_t state = 1;
    fast::pixels::BitMask A(size, size);
    fast::pixels::BitMask B(size, size);
    for (fast::pixels::BitMask* mask : {&A, &B}) {
      for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
          if ((next_bits(state) & 1U) != 0) mask->set(i, j);
        }
      }
    }
    const int times = std::max(1, 64 * 1024 * 1024 / (size * size));
    std::uint64_t sink = 0;
    const double read = nanoseconds(9, times, [&](int) {
      sink += read_all(A) + read_all(B);
      asm volatile("" : "+r"(sink) : : "memory");
    });
    for (const auto& [x, y] : {std::pair(0, 0), {64, 1}, {5, -3}}) {
      const double laid = nanoseconds(9, times, [&, dx = x, dy = y](int) {
        sink += static_cast<std::uint64_t>(fast::pixels::overlap(A, B, dx, dy).count);
        asm volatile("" : "+r"(sink) : : "memory");
      });
      std::printf("%8d (%3d,%3d) %12.0f %12.0f %7.2f\n", size, x, y, laid, read, laid / read);
    }
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

struct Subject {
  const char* name;
  Shape shape;
};

/// Turned about z alone: prisms meet where their pictures do, so the law of plane figures shows.
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

void misses(int pairs) {
  const std::vector<Subject> subjects = {
      {"boxes", Box{Vec3(0.5, 0.3, 0.5)}}, {"triangles", prism(3)}, {"16-gons", prism(16)}};
  std::printf("\noverlapping pairs that sampling misses, %d pairs a row\n%-10s %8s %10s %10s %12s %12s\n", pairs,
              "shape", "1/h", "missed", "of before", "pixel ns", "distance ns");
  std::vector<std::string> csv;
  for (const Subject& subject : subjects) {
    double before = 0;
    for (int fine = 4; fine <= 128; fine *= 2) {
      std::uint64_t state = 7;
      std::vector<Scene> scenes;
      while (static_cast<int>(scenes.size()) < pairs) {
        Scene scene;
        scene.bodies = {some_body(subject.shape, state), some_body(subject.shape, state)};
        const double h = 1.0 / fine;
        scene.raster = Raster{-2, -2, h, 4 * fine, 4 * fine, 0, 0};
        if (fast::distance(scene).verdict == Verdict::overlapping) scenes.push_back(scene);
      }
      int missed = 0;
      const double cost = nanoseconds(
          1, pairs, [&](int i) { missed += !any(fast::pixel(scenes[static_cast<std::size_t>(i)]).meet_sampled); });
      const double exact = nanoseconds(1, pairs, [&](int i) { fast::distance(scenes[static_cast<std::size_t>(i)]); });
      const double share = static_cast<double>(missed) / pairs;
      std::printf("%-10s %8d %10.5f %10.2f %12.0f %12.0f\n", subject.name, fine, share, before > 0 ? share / before : 0,
                  cost, exact);
      char line[160];
      std::snprintf(line, sizeof line, "%s,%d,%.6f,%.0f,%.0f", subject.name, fine, share, cost, exact);
      csv.emplace_back(line);
      before = share;
    }
  }
  std::printf("\nshape,pixels_per_metre,missed,pixel_ns,distance_ns\n");
  for (const std::string& line : csv) std::printf("%s\n", line.c_str());
}

}  // namespace

int main(int count, char** words) {
  masks();
  misses(count > 1 ? std::max(1, std::atoi(words[1])) : 1000);
}
