#include "app/profile/run_times.h"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace touchstone::app {

void RunTimes::count(double seconds) {
  constexpr double clock_unit = 1e-9;
  ++classes[static_cast<int>(std::lround(classes_per_octave * std::log2(std::max(seconds, clock_unit))))];
}

void RunTimes::merge(const RunTimes& later) {
  for (const auto& [k, count] : later.classes) classes[k] += count;
}

long RunTimes::total() const {
  long sum = 0;
  for (const auto& [k, count] : classes) sum += count;
  return sum;
}

double RunTimes::quantile(double share) const {
  const double wanted = share * static_cast<double>(total());
  long before = 0;
  for (const auto& [k, count] : classes) {
    before += count;
    if (static_cast<double>(before) >= wanted) return std::exp2(static_cast<double>(k) / classes_per_octave);
  }
  return std::exp2(static_cast<double>(classes.rbegin()->first) / classes_per_octave);
}

double thread_cpu_seconds() {
  timespec time{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace touchstone::app
