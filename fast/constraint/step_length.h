// How many short steps the next step is as long as.
#pragma once

#include <algorithm>

namespace touchstone::fast::constraint {

/// Steps grow while nothing changes. One in which something changes is refused, and the change is bisected down to a
/// short step.
class StepLength {
 public:
  /// `most` short steps: the longest step.
  explicit StepLength(int most) : most_(most) {}

  /// At most `left`.
  int next(int left) const { return std::min(left, until_change_ > 0 ? std::max(1, until_change_ / 2) : length_); }

  /// A step of that length was taken.
  void take(int steps) {
    if (until_change_ > 0) {
      until_change_ = std::max(0, until_change_ - steps);
      length_ = 1;
    } else {
      length_ = std::min(growth * length_, most_);
    }
  }
  /// Something changes within a step of that length.
  void refuse(int steps) { until_change_ = steps; }

 private:
  static constexpr int growth = 4;

  int most_, length_ = 1;
  int until_change_ = 0;  ///< short steps within which something changes; 0: unknown
};

}  // namespace touchstone::fast::constraint
