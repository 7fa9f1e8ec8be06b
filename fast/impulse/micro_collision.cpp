#include "fast/impulse/micro_collision.h"

namespace touchstone::fast::impulse {

Outcome micro_collision(Impact i) {
  if (!(i.un < 0)) return {};
  const double stuck = i.un - i.k1 / i.l1 * i.u1 - i.k2 / i.l2 * i.u2;  // u_n once slip has stopped
  const double p = -2 * stuck / (i.b - i.k1 / i.l1 * i.k1 - i.k2 / i.l2 * i.k2);
  const double P1 = (-2 * i.u1 - i.k1 * p) / i.l1, P2 = (-2 * i.u2 - i.k2 * p) / i.l2;
  if (p > 0 && P1 * P1 + P2 * P2 <= i.mu * p * (i.mu * p)) {
    Outcome reversed{P1, P2, p, p / 2, {}, 1};
    reversed.regime.approached = reversed.regime.stopped = true;
    return reversed;
  }
  i.law = Law::poisson;
  i.e = 1;
  return solve(i);
}

}  // namespace touchstone::fast::impulse
