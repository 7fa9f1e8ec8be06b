#include "fast/lin_canny/surround.h"

#include <algorithm>

namespace touchstone::fast::lin_canny {
namespace {

bool is_clear(const Simplex& s, double error) {
  double L = 0;
  for (int i = 0; i < 4; ++i) L = std::max(L, s.w(i).norm());
  const double margin = 4 * error * L * L + 16 * u * L * L * L;
  return *std::min_element(s.weights.begin(), s.weights.end()) > margin;
}

}  // namespace

std::optional<Vec3> common_point(const Simplex& around, double rounding_error) {
  if (!is_clear(around, 2 * rounding_error)) return std::nullopt;
  const auto& [points, weights, size] = around;
  const double sum = weights[0] + weights[1] + weights[2] + weights[3];
  Vec3 point = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k) point += weights[k] / sum * points[k].p_a;
  return point;
}

std::optional<Vec3> common_point(const PosedHull& A, const PosedHull& B) {
  Simplex held(lowest(A, B, B.t - A.t));
  for (int i = 0; i < most_vertices; ++i) {
    Vec3 toward;
    if (!reduce(held, toward)) return std::nullopt;
    if (held.size == 4) return common_point(held, rounding(A, B));
    const VertexDifference next = lowest(A, B, toward);
    if (!(toward.dot(next.w) < 0)) return std::nullopt;  // apart, or nearly so; or 0 is on the simplex
    held.add(next);
  }
  return std::nullopt;
}

}  // namespace touchstone::fast::lin_canny
