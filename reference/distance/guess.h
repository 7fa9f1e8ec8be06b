// GJK in plain floating point: a guess at the vertex pairs that span the nearest point of A − B. The guess may be
// wrong: the caller proves or improves it. Call it outside RoundUpward.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "reference/exact/simplex.h"

namespace touchstone::reference {

using VertexPair = std::pair<int, int>;  ///< vertex of A, vertex of B

namespace guess {

template <class T>
T squared_length(const NearestPoint<T>& y) {
  const T factor = y.height / y.denominator;
  return T(dot(y.direction, y.direction) * factor * factor);
}

/// The nearest among all subsets whose projection is inside them. Robust where rounding makes cofactors wrong.
template <class T>
std::optional<NearestPoint<T>> nearest(std::span<const Coordinates<T>> w) {
  std::optional<NearestPoint<T>> best;
  for (const unsigned mask : simplex::subsets) {
    if (mask >> w.size() != 0) continue;
    std::optional<NearestPoint<T>> y = simplex::interior_projection(w, mask);
    if (y && y->count == 4) return y;
    if (y && (!best || squared_length(*y) < squared_length(*best))) best = y;
  }
  return best;
}

template <class T>
int lowest(const std::vector<Coordinates<T>>& core, const Coordinates<T>& n) {
  int best = 0;
  T least = std::numeric_limits<T>::infinity();
  for (std::size_t i = 0; i < core.size(); ++i) {
    const T height = dot(n, core[i]);
    if (height < least) {
      least = height;
      best = static_cast<int>(i);
    }
  }
  return best;
}

}  // namespace guess

/// Returns 1 to 4 different pairs, possibly wrong. Never inlined, so that no compiler moves its arithmetic into a scope
/// of RoundUpward.
template <class T>
[[gnu::noinline]] std::vector<VertexPair> guess_nearest(const std::vector<Coordinates<T>>& A,
                                                        const std::vector<Coordinates<T>>& B) {
  constexpr int max_iterations = 100;
  std::vector<VertexPair> pairs = {{0, 0}};
  std::vector<Coordinates<T>> w = {A[0] - B[0]};
  T length = std::numeric_limits<T>::infinity();
  for (int i = 0; i < max_iterations; ++i) {
    const std::optional<NearestPoint<T>> y = guess::nearest(std::span<const Coordinates<T>>(w));
    if (!y) break;
    std::vector<VertexPair> kept;
    std::vector<Coordinates<T>> kept_w;
    for (int m = 0; m < y->count; ++m) {
      kept.push_back(pairs[static_cast<std::size_t>(y->members[static_cast<std::size_t>(m)])]);
      kept_w.push_back(w[static_cast<std::size_t>(y->members[static_cast<std::size_t>(m)])]);
    }
    const T now = guess::squared_length(*y);
    if (y->count < 4 && !(now < length)) break;  // no progress: keep the larger set, the exact route resolves it
    length = now;
    pairs = std::move(kept);
    w = std::move(kept_w);
    if (y->count == 4 || length == 0) break;
    const VertexPair next = {guess::lowest(A, y->direction), guess::lowest(B, Coordinates<T>(-y->direction))};
    if (std::find(pairs.begin(), pairs.end(), next) != pairs.end()) break;
    const Coordinates<T> step = A[static_cast<std::size_t>(next.first)] - B[static_cast<std::size_t>(next.second)];
    if (!(dot(y->direction, step - w[0]) < 0)) break;
    pairs.push_back(next);
    w.push_back(step);
  }
  return pairs;
}

}  // namespace touchstone::reference
