#include "fast/lin_canny/simplex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>

#include "fast/lin_canny/facing.h"

namespace touchstone::fast::lin_canny {
namespace {

double det(const Vec3& p, const Vec3& q, const Vec3& r) { return p.dot(q.cross(r)); }

/// A subset of a simplex, by pointers.
struct Subset {
  std::array<const VertexDifference*, 4> points{};
  std::array<double, 4> weights{};
  std::size_t size = 0;

  const Vec3& w(std::size_t i) const { return points[i]->w; }
};

/// Computes the weights of the point of the points' affine hull that is nearest to 0; returns a positive multiple of
/// that point.
Vec3 project_origin(Subset& s) {
  const Vec3& p = s.w(0);
  if (s.size == 1) {
    s.weights = {1};
    return p;
  }
  const Vec3& q = s.w(1);
  if (s.size == 2) {
    s.weights = {q.dot(q - p), -p.dot(q - p)};
    return s.weights[0] * p + s.weights[1] * q;
  }
  const Vec3& r = s.w(2);
  if (s.size == 3) {
    const Vec3 n = Vec3(q - p).cross(r - p);
    s.weights = {q.cross(r).dot(n), r.cross(p).dot(n), p.cross(q).dot(n)};
    return n.dot(p) < 0 ? Vec3(-n) : n;
  }
  const Vec3& t = s.w(3);
  s.weights = {det(q, r, t), -det(p, r, t), det(p, q, t), -det(p, q, r)};
  if (s.weights[0] < 0) {
    for (double& weight : s.weights) weight = -weight;
  }
  return Vec3::Zero();
}

bool all_positive(const Subset& s) {
  return std::all_of(s.weights.begin(), s.weights.begin() + static_cast<std::ptrdiff_t>(s.size),
                     [](double w) { return w > 0; });
}

Subset subset(const Simplex& held, unsigned members) {
  Subset some;
  for (std::size_t i = 0; i < static_cast<std::size_t>(held.size); ++i) {
    if ((members >> i & 1U) != 0) some.points[some.size++] = &held.points[i];
  }
  return some;
}

/// Whether the points of `held` that are not members lie on its plane or beyond.
bool is_lowest(const Subset& some, const Simplex& held, unsigned members, const Vec3& toward) {
  for (int i = 0; i < held.size; ++i) {
    if ((members >> i & 1U) == 0 && !(toward.dot(held.w(i) - some.w(0)) >= 0)) return false;
  }
  return true;
}

void keep(const Subset& some, Simplex& held) {
  for (std::size_t i = 0; i < some.size; ++i) held.points[i] = *some.points[i];  // ascending: none is overwritten early
  held.weights = some.weights;
  held.size = static_cast<int>(some.size);
}

}  // namespace

VertexDifference lowest(const PosedHull& A, const PosedHull& B, const Vec3& n) {
  const int a = highest(*A.hull, A.turned_in(n)), b = highest(*B.hull, B.turned_in(-n));
  const Vec3 p_a = A.vertex(a);
  return {a, b, p_a, B.vertex(b) - p_a};
}

bool reduce(Simplex& held, Vec3& toward) {
  constexpr unsigned by_size[] = {1, 2, 4, 8, 3, 5, 6, 9, 10, 12, 7, 11, 13, 14, 15};
  for (const unsigned members : by_size) {
    if (members >> held.size != 0) continue;
    Subset some = subset(held, members);
    toward = project_origin(some);
    if (!all_positive(some) || !is_lowest(some, held, members, toward)) continue;
    keep(some, held);
    return true;
  }
  return false;
}

}  // namespace touchstone::fast::lin_canny
