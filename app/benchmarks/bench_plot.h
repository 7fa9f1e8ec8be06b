// The table as a plot: one panel per workload, both axes logarithmic, each line labelled at its end.
#pragma once

#include <string>
#include <vector>

#include "app/benchmarks/bench_table.h"

namespace touchstone::app {

/// An SVG with its own background, light or dark as the reader's screen.
std::string bench_plot(const std::vector<BenchRow>& rows);

}  // namespace touchstone::app
