// The results of a comparison, and the table made from them.
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
  std::string law;           ///< the claimed growth of a frame's cost; may be empty
  std::optional<double> ns;  ///< CPU time per body and frame
  double count = 0;          ///< pairs per body; swaps per body and frame
  std::string left_out;      ///< why there is no figure
};

/// Reads workload,bodies,name,whose,law,ns_per_body_and_frame,pairs_per_body,left_out.
std::vector<BenchRow> bench_rows(const std::string& csv);

/// For each workload and name: ns at each size, growth, and the exponent of a frame's cost against n next to the
/// claimed law. Then the default strategy against each peer, the contestants that were left out, and the counted laws.
std::string bench_table(const std::vector<BenchRow>& rows);

/// The exponent b of y   x^b, by least squares of the logarithms. Requires at least two points.
double fitted_exponent(const std::vector<std::pair<double, double>>& points);

}  // namespace touchstone::app
