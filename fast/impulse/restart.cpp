#include "fast/impulse/restart.h"

#include <cmath>

namespace touchstone::fast::impulse {

Restart restart(const Impact& i) {
  Restart from;
  const double t1 = -i.k1 / i.l1, t2 = -i.k2 / i.l2;
  if (t1 * t1 + t2 * t2 <= i.mu * i.mu) {
    from.line = {t1, t2, i.b + (i.k1 * t1 + i.k2 * t2), 0};
    return from;
  }
  from.sticks = false;
  double lambda = 0;
  for (int step = 0; step < 100; ++step) {  // converges quadratically: some 6 steps
    const double m1 = i.l1 + lambda, m2 = i.l2 + lambda;
    const double x = i.k1 / m1, y = i.k2 / m2, square = x * x + y * y, length = std::sqrt(square);
    const double slope = (x * x / m1 + y * y / m2) / square;  // of −log |t|
    const double further = (length - i.mu) / (i.mu * slope);
    if (!(lambda + further > lambda)) break;
    lambda += further;
  }
  const double x = i.k1 / (i.l1 + lambda), y = i.k2 / (i.l2 + lambda), length = std::sqrt(x * x + y * y);
  from.c = x / length;
  from.d = y / length;
  from.line = sliding(i, from.c, from.d);
  if (from.line.g < 0) from.line.g = 0;  // at the edge of the rim, where it is 0 but for rounding
  return from;
}

}  // namespace touchstone::fast::impulse
