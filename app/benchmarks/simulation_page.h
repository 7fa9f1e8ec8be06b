// The results of `touchstone bench simulation` as a page of the documentation.
#pragma once

#include <string>

namespace touchstone::app {

/// Markdown: for each scene the known truth, our error, impacts and time, and the best result of each other engine;
/// then the scenes where another engine is better. `csv`:
/// workload,size,name,whose,ns,median_error,worst_error,left_out,impacts.
std::string simulation_page(const std::string& csv);

}  // namespace touchstone::app
