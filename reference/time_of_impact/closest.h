// The closest points of two moving cores in plain numbers, and the plane between them with its rate of change.
#pragma once

#include <optional>
#include <vector>

#include "reference/distance/guess.h"
#include "reference/time_of_impact/moving_plane.h"

namespace touchstone::reference {

/// x = Σ weights·a − Σ weights·b over the pairs is the nearest point of A − B to 0; at most three pairs.
template <class T>
struct Closest {
  std::vector<VertexPair> pairs;
  std::vector<T> weights;  ///< > 0
};

/// None if the cores seem to overlap. Call outside the tier's scope.
template <class Tier>
[[gnu::noinline]] std::optional<Closest<typename Tier::P>> closest(const Snapshot<Tier>& A, const Snapshot<Tier>& B) {
  using P = typename Tier::P;
  const std::vector<VertexPair> guess = guess_nearest(A.around, B.around);
  std::vector<Coordinates<P>> w;
  for (const auto& [a, b] : guess) {
    w.push_back(A.around[static_cast<std::size_t>(a)] - B.around[static_cast<std::size_t>(b)]);
  }
  const std::optional<NearestPoint<P>> y = guess::nearest(std::span<const Coordinates<P>>(w));
  if (!y || y->count == 4 || is_zero(y->direction)) return std::nullopt;
  Closest<P> result;
  for (int i = 0; i < y->count; ++i) {
    result.pairs.push_back(guess[static_cast<std::size_t>(y->members[static_cast<std::size_t>(i)])]);
    result.weights.push_back(y->weight[static_cast<std::size_t>(i)]);
  }
  return result;
}

template <class T>
Coordinates<T> without(const Coordinates<T>& v, const Coordinates<T>& n) {
  return v - T(dot(v, n) / dot(n, n)) * n;
}

/// n is normal to the span of the pairs' differences and points along them, |n| = 1. m = dn/dt without its component
/// along n, which only changes the length. None if the span has no normal. Call outside the tier's scope.
template <class Tier>
[[gnu::noinline]] std::optional<MovingPlane<typename Tier::P>> plane_between(const Closest<typename Tier::P>& closest,
                                                                             const Snapshot<Tier>& A,
                                                                             const Snapshot<Tier>& B) {
  using P = typename Tier::P;
  std::vector<Coordinates<P>> w, rate;
  for (const auto& [i, j] : closest.pairs) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    w.push_back(A.around[a] - B.around[b]);
    rate.push_back(middle(A.rates[a]) - middle(B.rates[b]));
  }
  Coordinates<P> n = w[0], m = rate[0];
  if (w.size() == 2) {  // n = w − s e, s = w·e/e·e
    const Coordinates<P> e = w[1] - w[0], f = rate[1] - rate[0];
    const P square = dot(e, e);
    const P s = dot(w[0], e) / square;
    const P s_rate = (dot(rate[0], e) + dot(w[0], f) - 2 * s * dot(e, f)) / square;
    n = w[0] - s * e;
    m = rate[0] - s_rate * e - s * f;
  }
  if (w.size() == 3) {  // n = e × f
    const Coordinates<P> e = w[1] - w[0], f = w[2] - w[0];
    n = cross(e, f);
    m = cross(Coordinates<P>(rate[1] - rate[0]), f) + cross(e, Coordinates<P>(rate[2] - rate[0]));
    if (dot(n, w[0]) < 0) {
      n = -n;
      m = -m;
    }
  }
  const P square = dot(n, n);
  if (!(square > 0)) return std::nullopt;
  const P scale = 1 / sqrt(square);
  return MovingPlane<P>{scale * n, scale * without(m, n)};
}

}  // namespace touchstone::reference
