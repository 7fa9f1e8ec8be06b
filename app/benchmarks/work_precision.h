// Work-precision tables and plots: the error of each contestant against its time.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchstone::app {

/// The result of one contestant at one size of one workload.
struct WorkPrecision {
  std::string workload;
  std::string size;  ///< "20"; the comparison says what it counts
  std::string name;
  std::string whose;                   ///< "ours"; "peer": ours is compared with it; else a row of another kind
  std::optional<double> ns;            ///< CPU time per query
  std::optional<double> median_error;  ///< against the exact answer; none: it gives no such answer
  std::optional<double> worst_error;
  std::string left_out;  ///< why there is no figure
};

/// The words that describe a comparison.
struct WorkPrecisionWords {
  std::string size;           ///< "vertices per body"
  std::string error;          ///< "ulps of the scene's scale"
  bool same_question = true;  ///< rows of one size answer the same queries; else a size is an effort
};

/// Reads workload,size,name,whose,ns,median_error,worst_error,left_out.
std::vector<WorkPrecision> work_precision_rows(const std::string& csv);

/// For each workload: ns and worst error of each name at each size, and growth; then ours against each peer; then the
/// contestants that were left out.
std::string work_precision_table(const std::vector<WorkPrecision>& rows, const WorkPrecisionWords& words);

/// An SVG: one panel per workload, time to the right and worst error upwards, both logarithmic. A line joins the sizes
/// of a name. Answers without any error are drawn below the axis.
std::string work_precision_plot(const std::vector<WorkPrecision>& rows, const WorkPrecisionWords& words);

}  // namespace touchstone::app
