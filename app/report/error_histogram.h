// The distribution of the errors of all answers, including the correct ones. A bound that holds says little about the
// errors below it.
#pragma once

#include <map>
#include <string>

#include "oracle/finding.h"

namespace touchstone::app {

struct ErrorHistogram {
  static constexpr int least_power = -10;  ///< errors below 2^least_power units count as this power

  std::string unit;            ///< of the first error; errors in other units are not counted. Empty: none counted
  long exact = 0;              ///< errors of 0
  std::map<int, long> powers;  ///< k -> errors in (2^(k−1), 2^k]; the least k also counts all smaller ones
  long infinite = 0;
  double largest = 0;

  /// Counts the error of an answer, if it has a size.
  void count(const oracle::Finding& finding);
  void merge(const ErrorHistogram& later);
  long total() const;
  /// An upper bound of the median, within a factor of 2: the upper edge of its power. Requires a total above 0.
  double median() const;
};

}  // namespace touchstone::app
