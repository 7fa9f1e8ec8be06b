// What `touchstone bench simulation` measured, as a page of documents.
#pragma once

#include <string>

namespace touchstone::app {

/// Markdown: per scene what is known, our error, impacts and time, the best of each other engine; then where we lose.
/// `csv`: workload,size,name,whose,ns,median_error,worst_error,left_out,impacts.
std::string simulation_page(const std::string& csv);

}  // namespace touchstone::app
