#include "fast/lin_canny/surround.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace touchstone::fast::lin_canny {
namespace {

/// A choice that ends a search: where it makes progress, it takes a few steps more than a simplex has vertices.
constexpr int most_vertices = 40;

struct Point {
  Vec3 a;  ///< of A, in the pair's frame
  Vec3 w;  ///< b − a
};

/// Up to four points, of which the first `size` count.
struct Simplex {
  std::array<Point, 4> points;
  std::array<double, 4> weights{};
  int size = 0;

  const Vec3& w(int i) const { return points[static_cast<std::size_t>(i)].w; }
};

int highest(const Hull& hull, const Vec3& n) {
  int best = 0;
  double most = n.dot(hull.vertex(0));
  for (int v = 1; v < hull.vertex_count(); ++v) {
    const double height = n.dot(hull.vertex(v));
    if (height > most) best = v;
    most = std::max(most, height);
  }
  return best;
}

/// The difference lowest along n.
Point lowest(const PosedHull& A, const PosedHull& B, const Vec3& n) {
  const Vec3 a = A.vertex(highest(*A.hull, A.turned_in(n)));
  return {a, B.vertex(highest(*B.hull, B.turned_in(-n))) - a};
}

double det(const Vec3& p, const Vec3& q, const Vec3& r) { return p.dot(q.cross(r)); }

/// Computes the weights of the point of the points' affine hull that is nearest to 0; returns a positive multiple of
/// that point.
Vec3 project_origin(Simplex& s) {
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

bool all_positive(const Simplex& s) {
  return std::all_of(s.weights.begin(), s.weights.begin() + s.size, [](double w) { return w > 0; });
}

/// Leaves the least subset that contains the nearest point to 0 in its interior, as far as doubles can tell; false if
/// they find none.
bool reduce(Simplex& held, Vec3& toward) {
  for (int size = 1; size <= held.size; ++size) {
    for (unsigned members = 1; members < 1U << held.size; ++members) {
      if (__builtin_popcount(members) != size) continue;
      Simplex some;
      for (int i = 0; i < held.size; ++i) {
        if ((members >> i & 1U) != 0) {
          some.points[static_cast<std::size_t>(some.size++)] = held.points[static_cast<std::size_t>(i)];
        }
      }
      toward = project_origin(some);
      if (!all_positive(some)) continue;
      bool none_beyond = true;
      for (int i = 0; i < held.size; ++i) {
        none_beyond = none_beyond && ((members >> i & 1U) != 0 || toward.dot(held.w(i) - some.w(0)) >= 0);
      }
      if (!none_beyond) continue;
      held = some;
      return true;
    }
  }
  return false;
}

bool is_clear(const Simplex& s, double error) {
  double L = 0;
  for (int i = 0; i < 4; ++i) L = std::max(L, s.w(i).norm());
  const double margin = 4 * error * L * L + 16 * u * L * L * L;
  return *std::min_element(s.weights.begin(), s.weights.end()) > margin;
}

}  // namespace

std::optional<Vec3> common_point(const PosedHull& A, const PosedHull& B) {
  Simplex held;
  held.points[0] = lowest(A, B, B.t - A.t);
  held.size = 1;
  for (int i = 0; i < most_vertices; ++i) {
    Vec3 toward;
    if (!reduce(held, toward)) return std::nullopt;
    if (held.size == 4) {
      if (!is_clear(held, 2 * rounding(A, B))) return std::nullopt;
      const double sum = held.weights[0] + held.weights[1] + held.weights[2] + held.weights[3];
      Vec3 point = Vec3::Zero();
      for (std::size_t k = 0; k < 4; ++k) point += held.weights[k] / sum * held.points[k].a;
      return point;
    }
    const Point next = lowest(A, B, toward);
    if (!(toward.dot(next.w) < 0)) return std::nullopt;  // apart, or nearly so; or 0 is on the simplex
    held.points[static_cast<std::size_t>(held.size++)] = next;
  }
  return std::nullopt;
}

}  // namespace touchstone::fast::lin_canny
