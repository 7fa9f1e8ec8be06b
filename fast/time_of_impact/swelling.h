// By how much a body counts as thicker than it is, where it may be off its path.
#pragma once

namespace touchstone::fast {

/// at_first + rate (t − since), both ≥ 0 (m, m/s), on all sides.
struct Swelling {
  double since = 0, at_first = 0, rate = 0;

  double at(double t) const { return at_first + rate * (t - since); }
  bool is_none() const { return at_first == 0 && rate == 0; }
};

}  // namespace touchstone::fast
