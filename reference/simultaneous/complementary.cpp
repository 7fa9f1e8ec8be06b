#include "reference/simultaneous/complementary.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace touchstone::reference {
namespace {

/// The index of the greatest approach, u + K p < 0; none if nothing approaches.
std::optional<std::size_t> fastest(const RationalMatrix& K, const RationalVector& u, const RationalVector& p) {
  std::optional<std::size_t> found;
  mpq_class least = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const mpq_class after = u[i] + inner(K[i], p);
    if (after < least) {
      least = after;
      found = i;
    }
  }
  return found;
}

}  // namespace

std::optional<RationalVector> complementary(const RationalMatrix& K, const RationalVector& u) {
  RationalVector p(u.size());
  std::vector<std::size_t> pressing;
  while (const std::optional<std::size_t> next = fastest(K, u, p)) {
    pressing.push_back(*next);
    while (true) {
      RationalVector stopping;
      for (const std::size_t i : pressing) stopping.emplace_back(-u[i]);
      const std::optional<RationalVector> wanted = solution(part(K, pressing), stopping);
      if (!wanted) return std::nullopt;
      // The greatest part of the way at which no impulse is negative.
      mpq_class part = 1;
      for (std::size_t k = 0; k < pressing.size(); ++k) {
        const mpq_class& now = p[pressing[k]];
        if (sgn((*wanted)[k]) < 0) part = std::min(part, mpq_class(now / (now - (*wanted)[k])));
      }
      for (std::size_t k = 0; k < pressing.size(); ++k) p[pressing[k]] += part * ((*wanted)[k] - p[pressing[k]]);
      std::erase_if(pressing, [&](std::size_t i) { return sgn(p[i]) == 0; });
      if (part == 1) break;
    }
  }
  return p;
}

}  // namespace touchstone::reference
