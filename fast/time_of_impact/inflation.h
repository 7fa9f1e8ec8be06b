// The margin by which a body is inflated where its trajectory is uncertain.
#pragma once

namespace touchstone::fast {

/// The margin at_first + rate (t − since) on all sides; both coefficients are ≥ 0 (m, m/s).
struct Inflation {
  double since = 0, at_first = 0, rate = 0;

  double at(double t) const { return at_first + rate * (t - since); }
  bool is_none() const { return at_first == 0 && rate == 0; }
};

}  // namespace touchstone::fast
