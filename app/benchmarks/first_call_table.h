// The table of the law that no query of `fast` is slower than the exact reference, from the first call on.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchstone::app {

/// Questions that both were asked once.
struct FirstCall {
  std::string query;
  std::string scenes;             ///< how many
  std::string questions;          ///< what they have in common
  std::optional<double> fast_ns;  ///< the mean of the scenes that both answer; none: there is no such scene
  std::optional<double> reference_ns;
  double worst_ratio = 0;  ///< the greatest of one scene
  std::string left_out;    ///< how many scenes one of the two did not answer
};

/// Reads query,scenes,questions,fast_ns,reference_ns,worst_ratio,left_out.
std::vector<FirstCall> first_call_rows(const std::string& csv);

/// For each query a row of each kind of questions: microseconds of both, their ratio, and the greatest ratio of one
/// scene. Then the rows whose ratio is above 1, those with a scene above 1, and the scenes that were left out.
std::string first_call_table(const std::vector<FirstCall>& rows);

}  // namespace touchstone::app
