#include "app/report/error_histogram.h"

#include <algorithm>
#include <cmath>

#include "model/infinity.h"

namespace touchstone::app {

void ErrorHistogram::count(const oracle::Finding& finding) {
  if (finding.unit.empty() || finding.unit == oracle::without_size) return;
  if (unit.empty()) unit = finding.unit;
  if (unit != finding.unit || std::isnan(finding.error)) return;
  largest = std::max(largest, finding.error);
  if (!(finding.error > 0)) {
    ++exact;
  } else if (std::isinf(finding.error)) {
    ++infinite;
  } else {
    int power = 0;
    const double fraction = std::frexp(finding.error, &power);  // in [1/2, 1)
    ++powers[std::max(least_power, fraction == 0.5 ? power - 1 : power)];
  }
}

void ErrorHistogram::merge(const ErrorHistogram& later) {
  if (unit.empty()) unit = later.unit;
  if (unit != later.unit) return;
  exact += later.exact;
  infinite += later.infinite;
  largest = std::max(largest, later.largest);
  for (const auto& [power, count] : later.powers) powers[power] += count;
}

long ErrorHistogram::total() const {
  long sum = exact + infinite;
  for (const auto& [power, count] : powers) sum += count;
  return sum;
}

double ErrorHistogram::median() const {
  const long half = (total() + 1) / 2;
  long before = exact;
  if (before >= half) return 0;
  for (const auto& [power, count] : powers) {
    before += count;
    if (before >= half) return std::min(largest, std::ldexp(1.0, power));
  }
  return infinity;
}

}  // namespace touchstone::app
