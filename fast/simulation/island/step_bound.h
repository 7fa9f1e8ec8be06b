// The temporary bound of an island's steps, where a contact comes near.
#pragma once

#include <algorithm>

#include "model/infinity.h"

namespace touchstone::fast::simulation {

/// Once the contact has come there is no more reason for short steps. So the bound grows by 2, 4, 16, 256 … after steps
/// that end as planned.
class StepBound {
 public:
  double longest() const { return longest_; }  ///< s; infinity: no bound

  /// No step is longer than `h` (s).
  void limit(double h) { longest_ = std::min(longest_, h); }
  /// Likewise, and the growth begins again.
  void shorten(double h) {
    limit(h);
    growth_ = first_growth;
  }
  void lengthen() {
    longest_ *= growth_;
    growth_ = std::min(growth_ * growth_, most_growth);
  }
  /// The contact has come.
  void lift() { longest_ = infinity; }
  /// Takes over the stricter bound.
  void absorb(const StepBound& other) {
    limit(other.longest_);
    growth_ = std::min(growth_, other.growth_);
  }

 private:
  static constexpr double first_growth = 2, most_growth = 0x1p20;

  double longest_ = infinity;
  double growth_ = first_growth;  ///< after the next step that ends as planned
};

}  // namespace touchstone::fast::simulation
