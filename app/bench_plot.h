// The table as a picture: a panel a workload, both axes logarithmic, each line named at its end.
#pragma once

#include <string>
#include <vector>

#include "app/bench_table.h"

namespace touchstone::app {

/// An SVG on its own ground, light or dark as the reader's screen is.
std::string bench_plot(const std::vector<BenchRow>& rows);

}  // namespace touchstone::app
