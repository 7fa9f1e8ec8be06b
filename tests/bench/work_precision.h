// What the comparisons of errors against times share: their CSV is read by app/benchmarks/work_precision.h.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/bench/command_line.h"

namespace touchstone::bench {

/// The greater of the middle two. Requires a value.
inline double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// Prints the head of the CSV, and calls compare(workload, size, rounds) for each workload and size.
template <class Compare>
void compare_each(const Options& options, Compare&& compare) {
  std::printf("workload,size,name,whose,ns,median_error,worst_error,left_out\n");
  for (const std::string& workload : options.workloads) {
    for (const int size : options.sizes) compare(workload, size, options.rounds);
  }
}

}  // namespace touchstone::bench
