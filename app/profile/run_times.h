// The CPU times of a subject's answers to one query. They are no result: no verdict, and no file but report.timing.json
// and the page's section on speed, depends on them.
#pragma once

#include <map>

namespace touchstone::app {

/// Counts times in classes that are 2^(1/16) wide, so that a median is within 2.2 % and millions of answers take no
/// space.
struct RunTimes {
  static constexpr int classes_per_octave = 16;

  std::map<int, long> classes;  ///< k -> times within half a class of 2^(k/16) s

  /// If the clock did not advance, as its least unit: the number of times is that of the questions.
  void count(double seconds);
  void merge(const RunTimes& later);
  long total() const;
  /// s: so many of the times are shorter. Requires 0 ≤ share ≤ 1 and at least one time.
  double quantile(double share) const;
};

/// s: the CPU time of this thread until now.
double thread_cpu_seconds();

}  // namespace touchstone::app
