#include "fast/exact/surrounded.h"

#include <optional>

namespace touchstone::fast::exact {
namespace {

using Points = std::vector<Vector>;

bool supports(const Vector& n, const Points& found) {
  for (const Vector& w : found) {
    if (dot(n, w).sign() < 0) return false;
  }
  return true;
}

/// A direction perpendicular to v ≠ 0.
Vector across(const Vector& v) {
  const Vector n = cross(v, Vector{1, 0, 0});
  return n.is_zero() ? cross(v, Vector{0, 1, 0}) : n;
}

/// A direction from the middle of the cone {n : n·w ≥ 0 for all found}; none if the cone is {0}. The cone's edges are
/// perpendicular to two of the w; they are summed at roughly equal lengths.
std::optional<Vector> middle(const Points& found) {
  std::optional<Vector> some;
  Vector sum;
  const Vector* longest = nullptr;
  bool all_parallel = true;
  for (const Vector& v : found) {
    if (!v.is_zero()) longest = &v;
    for (const Vector* w = found.data(); w != &v; ++w) {
      const Vector n = cross(*w, v);
      if (n.is_zero()) continue;
      all_parallel = false;
      for (const Vector& edge : {n, -n}) {
        if (!supports(edge, found)) continue;
        some = edge;
        sum = sum + at_unit_scale(edge);
      }
    }
  }
  if (longest == nullptr) return Vector{0, 0, 1};
  if (all_parallel) return across(*longest);
  return sum.is_zero() ? some : std::optional(sum);
}

}  // namespace

void classify_contact(Difference& difference, Nearest& answer) {
  answer.around = answer.pairs;
  Points found;
  for (const VertexPair& pair : answer.around) found.push_back(difference(pair));
  while (const std::optional<Vector> n = middle(found)) {
    const VertexPair beyond = difference.support(*n);
    const Vector w = difference(beyond);
    if (dot(*n, w).sign() >= 0) {
      answer.verdict = Verdict::touching;
      answer.normal = *n;
      answer.around.clear();
      return;
    }
    answer.around.push_back(beyond);
    found.push_back(w);
  }
  answer.verdict = Verdict::overlapping;
}

}  // namespace touchstone::fast::exact
