// Error against time: what a comparison of answers that can be wrong measured, as a table and as a picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchstone::app {

/// What one contestant does at one size of one workload.
struct WorkPrecision {
  std::string workload;
  std::string size;  ///< "20": of what, the comparison says
  std::string name;
  std::string whose;                   ///< "ours"; "peer": ours is set against it; else something beside them
  std::optional<double> ns;            ///< CPU time a query
  std::optional<double> median_error;  ///< against the exact answer; none: it gives no such answer
  std::optional<double> worst_error;
  std::string left_out;  ///< why there is no figure
};

/// What is compared, in words.
struct WorkPrecisionWords {
  std::string size;           ///< "vertices a body"
  std::string error;          ///< "ulps of the scene's scale"
  bool same_question = true;  ///< one size asks all the same; else sizes are efforts, and times at one do not compare
};

/// Reads workload,size,name,whose,ns,median_error,worst_error,left_out.
std::vector<WorkPrecision> work_precision_rows(const std::string& csv);

/// Per workload: ns and worst error of each name at each size, growth; then ours against each peer; then who was left
/// out.
std::string work_precision_table(const std::vector<WorkPrecision>& rows, const WorkPrecisionWords& words);

/// An SVG: a panel a workload, time to the right and worst error upwards, both logarithmic; a line joins the sizes of a
/// name. Below the axis: no error at all.
std::string work_precision_plot(const std::vector<WorkPrecision>& rows, const WorkPrecisionWords& words);

}  // namespace touchstone::app
