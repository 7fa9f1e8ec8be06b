// What a comparison measured, and the table that is made of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchstone::app {

struct BenchRow {
  std::string workload;  ///< "swaps.…": counted, not timed
  std::size_t bodies = 0;
  std::string name;
  bool peer = false;
  std::string law;           ///< how a frame's cost is claimed to grow; may be empty
  std::optional<double> ns;  ///< CPU time a body and frame
  double count = 0;          ///< pairs a body; swaps a body and frame
  std::string left_out;      ///< why there is no figure
};

/// Reads workload,bodies,name,whose,law,ns_per_body_and_frame,pairs_per_body,left_out.
std::vector<BenchRow> bench_rows(const std::string& csv);

/// Per workload and name: ns at each size, growth, and the exponent of a frame's cost against n beside the claimed law;
/// then the default against each peer, who was left out, and the counted laws.
std::string bench_table(const std::vector<BenchRow>& rows);

/// The exponent b of y ~ x^b, by least squares of the logarithms. Requires two points or more.
double fitted_exponent(const std::vector<std::pair<double, double>>& points);

}  // namespace touchstone::app
