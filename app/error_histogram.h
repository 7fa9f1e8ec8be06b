// How large the errors of all answers were, the right ones' too: a bound that holds says little, the spread says the
// rest.
#pragma once

#include <map>
#include <string>

#include "oracle/finding.h"

namespace touchstone::app {

struct ErrorHistogram {
  static constexpr int least_power = -10;  ///< who errs by a thousandth of a unit errs by nothing

  std::string unit;            ///< of the first error counted; others are left out. Empty: nothing was
  long exact = 0;              ///< errors of 0
  std::map<int, long> powers;  ///< k -> errors in (2^(k−1), 2^k]; of the least k all smaller ones too
  long infinite = 0;
  double largest = 0;

  /// Of an answer whose error has a size.
  void count(const oracle::Finding& finding);
  void merge(const ErrorHistogram& later);
  long total() const;
};

}  // namespace touchstone::app
