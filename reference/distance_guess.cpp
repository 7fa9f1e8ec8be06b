// A plain GJK in doubles. It may be wrong and costs nothing: distance_certified.cpp proves or improves what it says.
#include <algorithm>
#include <limits>

#include "reference/distance_guess_impl.h"
#include "reference/simplex_impl.h"

namespace touchstone::reference {
namespace {

using Point = NearestPoint<double>;

double squared_length(const Point& y) {
  const double factor = y.height / y.denominator;
  return dot(y.direction, y.direction) * factor * factor;
}

/// Of all subsets whose projection is inside, the nearest: robust where rounding makes cofactors lie.
std::optional<Point> nearest(std::span<const PlainVec> w) {
  std::optional<Point> best;
  for (const unsigned mask : simplex::subsets) {
    if (mask >> w.size() != 0) continue;
    std::optional<Point> y = simplex::interior_projection(w, mask);
    if (y && y->count == 4) return y;
    if (y && (!best || squared_length(*y) < squared_length(*best))) best = y;
  }
  return best;
}

int lowest(const PosedCore& core, const PlainVec& n) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < core.size(); ++i) {
    const double height = dot(n, core.plain(i));
    if (height < least) {
      least = height;
      best = i;
    }
  }
  return best;
}

}  // namespace

std::vector<VertexPair> guess_nearest(const PosedPair& pair) {
  constexpr int patience = 100;
  std::vector<VertexPair> pairs = {{0, 0}};
  std::vector<PlainVec> w = {pair.A.plain(0) - pair.B.plain(0)};
  double length = std::numeric_limits<double>::infinity();
  for (int i = 0; i < patience; ++i) {
    const std::optional<Point> y = nearest(w);
    if (!y) break;
    std::vector<VertexPair> kept;
    std::vector<PlainVec> kept_w;
    for (int m = 0; m < y->count; ++m) {
      kept.push_back(pairs[static_cast<std::size_t>(y->members[static_cast<std::size_t>(m)])]);
      kept_w.push_back(w[static_cast<std::size_t>(y->members[static_cast<std::size_t>(m)])]);
    }
    const double now = squared_length(*y);
    if (y->count < 4 && !(now < length)) break;  // no progress: keep the larger set, the exact side sorts it out
    length = now;
    pairs = std::move(kept);
    w = std::move(kept_w);
    if (y->count == 4 || length == 0) break;
    const VertexPair next = {lowest(pair.A, y->direction), lowest(pair.B, -y->direction)};
    if (std::find(pairs.begin(), pairs.end(), next) != pairs.end()) break;
    const PlainVec step = pair.A.plain(next.first) - pair.B.plain(next.second);
    if (!(dot(y->direction, step - w[0]) < 0)) break;
    pairs.push_back(next);
    w.push_back(step);
  }
  return pairs;
}

}  // namespace touchstone::reference
