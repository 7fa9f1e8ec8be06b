// The default route: a guess in doubles, then GJK in exact arithmetic from there. Every exact step descends strictly,
// so it ends. A vertex is evaluated exactly only if its interval does not decide on which side of the plane it lies.
#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>

#include "reference/distance/guess.h"
#include "reference/distance/routes.h"
#include "reference/distance/touching_only.h"
#include "reference/exact/simplex.h"

namespace touchstone::reference {
namespace {

/// The point of scale·(A − B) + shift nearest to 0.
struct Minimum {
  std::vector<VertexPair> pairs;
  std::vector<Integer> weights;  ///< > 0; Σ weights·(scale·(a − b) + shift) / total = direction·height / denominator
  Integer total;                 ///< Σ weights
  IntegerVec direction;
  Integer height;
  Integer denominator;
  std::vector<int> lowest_A;  ///< if direction ≠ 0: all vertices of A lowest along it, all of B highest
  std::vector<int> highest_B;
};

/// The first subset whose projection is inside it and that has no other member below it. It is the nearest one, by
/// convexity.
NearestPoint<Integer> nearest_point(std::span<const IntegerVec> w) {
  for (const unsigned mask : simplex::subsets) {
    if (mask >> w.size() != 0) continue;
    std::optional<NearestPoint<Integer>> y = simplex::interior_projection(w, mask);
    if (!y) continue;
    const IntegerVec& base = w[static_cast<std::size_t>(y->members[0])];
    bool lowest = true;
    for (std::size_t i = 0; i < w.size() && lowest; ++i) {
      lowest = (mask >> i & 1U) != 0 || dot(y->direction, w[i] - base) >= 0;
    }
    if (lowest) return *std::move(y);
  }
  throw std::logic_error("a simplex without a nearest point");
}

struct Below {
  int vertex = -1;        ///< the lowest below `from` along n; -1 if none
  std::vector<int> ties;  ///< at the same height as `from`, ascending
};

Below below(const PosedCore& core, const IntegerVec& n, int from) {
  const EnclosureVec around = enclosure(n);
  Below result;
  double least = 0;
  for (int i = 0; i < core.size(); ++i) {
    const int sign = side(core, n, around, i, from);
    if (sign == 0) result.ties.push_back(i);
    if (sign >= 0) continue;
    const double height = dot(around, core.enclosed(i) - core.enclosed(from)).inf();
    if (result.vertex < 0 || height < least) {
      result.vertex = i;
      least = height;
    }
  }
  return result;
}

/// Divides the weights by their large common divisor, which comes from products of |q|².
void reduce_weights(Minimum& m) {
  Integer common = m.total;
  for (const Integer& weight : m.weights) common = gcd(common, weight);
  for (Integer& weight : m.weights) weight /= common;
  m.total /= common;
}

Minimum minimise(const PosedPair& pair, std::vector<VertexPair> pairs, const Integer& scale, const IntegerVec& shift) {
  while (true) {
    std::vector<IntegerVec> w;
    for (const auto& [a, b] : pairs) w.push_back(scale * pair.difference(a, b) + shift);
    NearestPoint<Integer> y = nearest_point(w);
    Minimum m;
    for (int i = 0; i < y.count; ++i) {
      m.pairs.push_back(pairs[static_cast<std::size_t>(y.members[static_cast<std::size_t>(i)])]);
      m.weights.push_back(std::move(y.weight[static_cast<std::size_t>(i)]));
    }
    m.total = std::move(y.total);
    m.direction = std::move(y.direction);
    m.height = std::move(y.height);
    m.denominator = std::move(y.denominator);
    if (is_zero(m.direction)) {
      reduce_weights(m);
      return m;
    }

    const auto [a, b] = m.pairs[0];
    Below below_A = below(pair.A, m.direction, a);
    Below above_B = below(pair.B, -m.direction, b);
    if (below_A.vertex < 0 && above_B.vertex < 0) {
      reduce_weights(m);
      m.lowest_A = std::move(below_A.ties);
      m.highest_B = std::move(above_B.ties);
      return m;
    }
    pairs = std::move(m.pairs);
    pairs.emplace_back(below_A.vertex < 0 ? a : below_A.vertex, above_B.vertex < 0 ? b : above_B.vertex);
  }
}

/// Four vertices that span a volume.
std::vector<int> tetrahedron(const PosedCore& core) {
  std::vector<int> corners = {0, 1};
  const IntegerVec first = core.exact(1) - core.exact(0);
  IntegerVec normal;
  for (int i = 2; i < core.size(); ++i) {
    const IntegerVec edge = core.exact(i) - core.exact(0);
    if (corners.size() == 2) {
      normal = cross(first, edge);
      if (!is_zero(normal)) corners.push_back(i);
    } else if (dot(normal, edge) != 0) {
      corners.push_back(i);
      return corners;
    }
  }
  throw std::logic_error("a polytope without volume");
}

/// 0 is inside A − B but on the boundary of the simplex found. Take any tetrahedron T of differences and the sum q of
/// its corners. −εq is in A − B for some ε > 0, so 0 is a positive combination of the corners of T and of the
/// differences that make up −εq.
void prove_overlap(const PosedPair& pair, CoreNearest& result) {
  std::vector<VertexPair> corners;
  if (pair.A.is_point()) {
    for (const int b : tetrahedron(pair.B)) corners.emplace_back(0, b);
  } else {
    for (const int a : tetrahedron(pair.A)) corners.emplace_back(a, 0);
  }
  IntegerVec sum;
  for (const auto& [a, b] : corners) sum = sum + pair.difference(a, b);
  Integer scale = 4;
  Minimum m = minimise(pair, corners, scale, sum);
  for (; !is_zero(m.direction); m = minimise(pair, m.pairs, scale, sum)) scale *= scale;

  std::map<VertexPair, Integer> weights;
  for (const VertexPair& corner : corners) weights[corner] += m.total;
  for (std::size_t i = 0; i < m.pairs.size(); ++i) weights[m.pairs[i]] += scale * m.weights[i];
  result.pairs.clear();
  result.weights.clear();
  result.total = 0;
  for (const auto& [vertices, weight] : weights) {
    result.pairs.push_back(vertices);
    result.weights.push_back(weight);
    result.total += weight;
  }
}

void locate(const PosedPair& pair, const Minimum& m, CoreNearest& result) {
  const auto [a, b] = m.pairs[0];
  const bool at_a = std::all_of(m.pairs.begin(), m.pairs.end(), [a = a](const VertexPair& p) { return p.first == a; });
  const bool at_b = std::all_of(m.pairs.begin(), m.pairs.end(), [b = b](const VertexPair& p) { return p.second == b; });
  result.point_is_of_B = at_b && !at_a;
  if (at_a) {
    result.point = {pair.A.exact(a), 1};
  } else if (at_b) {
    result.point = {pair.B.exact(b), 1};
  } else {
    result.point = {{}, m.total};
    for (std::size_t i = 0; i < m.pairs.size(); ++i) {
      result.point.num = result.point.num + m.weights[i] * pair.A.exact(m.pairs[i].first);
    }
  }
}

}  // namespace

CoreNearest nearest_certified(PosedPair& pair) {
  std::vector<VertexPair> guess = guess_nearest(pair.A.plain(), pair.B.plain());
  const RoundUpward rounding;
  pair.A.enclose();
  pair.B.enclose();
  Minimum m = minimise(pair, std::move(guess), 1, {});

  CoreNearest result;
  locate(pair, m, result);
  result.normal = std::move(m.direction);
  result.height = std::move(m.height);
  result.denominator = std::move(m.denominator);
  result.total = std::move(m.total);
  result.pairs = std::move(m.pairs);
  result.weights = std::move(m.weights);
  result.face_A = std::move(m.lowest_A);
  result.face_B = std::move(m.highest_B);
  if (!is_zero(result.normal)) return result;

  if (result.pairs.size() < 4) {
    if (std::optional<SupportingPlane> plane = supporting_plane(pair, result.pairs)) {
      result.cores = Verdict::touching;
      result.direction = std::move(plane->normal);
      result.face_A = std::move(plane->on_A);
      result.face_B = std::move(plane->on_B);
      return result;
    }
    prove_overlap(pair, result);
  }
  result.cores = Verdict::overlapping;
  return result;
}

}  // namespace touchstone::reference
