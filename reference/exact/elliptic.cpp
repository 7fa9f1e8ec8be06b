#include "reference/exact/elliptic.h"

#include <algorithm>

namespace touchstone::reference {

using E = WideEnclosure;

E first_kind(E x, E y, E z) {
  constexpr int enough = 72;  // each gains two binary digits of the difference: 2^-144, squared
  for (int i = 0; i < enough; ++i) {
    const E a = root(x), b = root(y), c = root(z);
    const E lambda = a * b + b * c + c * a;
    x = (a * a + lambda) / E(4);
    y = (b * b + lambda) / E(4);
    z = (c * c + lambda) / E(4);
  }
  const E three(3);
  const E least = E(1) / root(E((x + y + z) / three));
  const E most = root(E((E(1) / x + E(1) / y + E(1) / z) / three));
  return between(lower(least), upper(most));
}

}  // namespace touchstone::reference
