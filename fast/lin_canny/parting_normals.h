// Directions among which there is one that separates two convex bodies, if any does (separating axis theorem).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <vector>

#include "fast/lin_canny/posed_hull.h"
#include "model/infinity.h"

namespace touchstone::fast::lin_canny {

/// An edge of a posed hull, and the directions in its two faces that lead away from it at right angles.
struct TurnedEdge {
  TurnedEdge(const PosedHull& hull, int index)
      : along(hull.edge_vector(index)),
        length(along.norm()),
        into{hull.turned_out(normal(hull, index, 0)).cross(along),
             along.cross(hull.turned_out(normal(hull, index, 1)))} {}

  static const Vec3& normal(const PosedHull& hull, int index, std::size_t side) {
    return hull.hull->face(hull.hull->edge(index).face[side]).normal;
  }

  Vec3 along;
  double length;
  std::array<Vec3, 2> into;
};

/// A choice: the least sine of two edges whose cross product defines a direction. Its error is some u over that.
inline constexpr double least_crossing = 0x1p-40;

/// Of n, a multiple of e × f for nearly parallel unit vectors, what is perpendicular to both: the rest is rounding.
inline Vec3 across_both(Vec3 n, const Vec3& e, const Vec3& f) {
  n -= n.dot(e) * e;
  n -= n.dot(f) * f;
  return n;
}

/// Whether `found` returns true for one of the normals, from B to A, of planes along a face of B, a face of A, or an
/// edge of each: found(n, features), where a vertex stands for no feature. Calls it in a fixed order, and stops at the
/// first true. Edges that cross at less than least_crossing define no direction. A plane along two edges that cuts a
/// face beside one of them, at a slope above 2⁻³⁰ and rounding, is left out: it is along no face of the Minkowski
/// difference, so it is not needed, and few of the thousands of planes are.
template <class Found>
bool any_parting_normal(const PosedHull& A, const PosedHull& B, Found&& found) {
  for (int f = 0; f < A.hull->face_count(); ++f) {
    if (found(Vec3(-A.turned_out(A.hull->face(f).normal)), FeaturePair{{Kind::face, f}, {}})) return true;
  }
  for (int f = 0; f < B.hull->face_count(); ++f) {
    if (found(B.turned_out(B.hull->face(f).normal), FeaturePair{{}, {Kind::face, f}})) return true;
  }
  if (A.hull->edge_count() == 0) return false;  // a ball's core
  std::vector<TurnedEdge> edges_of_B;
  for (int j = 0; j < B.hull->edge_count(); ++j) edges_of_B.emplace_back(B, j);
  for (int i = 0; i < A.hull->edge_count(); ++i) {
    const TurnedEdge a(A, i);
    for (int j = 0; j < B.hull->edge_count(); ++j) {
      const TurnedEdge& b = edges_of_B[static_cast<std::size_t>(j)];
      const FeaturePair edges{{Kind::edge, i}, {Kind::edge, j}};
      Vec3 n = a.along.cross(b.along);
      const double size = n.norm(), unit = a.length * b.length;
      if (!(size > least_crossing * unit)) continue;
      if (size < 0x1p-20 * unit) n = across_both(n, a.along / a.length, b.along / b.length);
      const double flat = std::max(0x1p-30 * size, 16 * u * unit);
      const double flat_A = flat * a.length, flat_B = flat * b.length;
      const double A_0 = n.dot(a.into[0]), A_1 = n.dot(a.into[1]);
      const bool up = A_0 >= -flat_A && A_1 >= -flat_A, down = A_0 <= flat_A && A_1 <= flat_A;
      if (!up && !down) continue;
      const double B_0 = n.dot(b.into[0]), B_1 = n.dot(b.into[1]);
      if (up && B_0 <= flat_B && B_1 <= flat_B && found(Vec3(n / size), edges)) return true;
      if (down && B_0 >= -flat_B && B_1 >= -flat_B && found(Vec3(-n / size), edges)) return true;
    }
  }
  return false;
}

/// Among these normals the one with the greatest `width`; the first of several.
template <class Width>
Vec3 widest_parting_normal(const PosedHull& A, const PosedHull& B, Width&& width) {
  Vec3 best = Vec3::UnitZ();
  double widest = -infinity;
  any_parting_normal(A, B, [&](const Vec3& n, const FeaturePair&) {
    const double wide = width(n);
    if (wide > widest) widest = wide, best = n;
    return false;
  });
  return best;
}

}  // namespace touchstone::fast::lin_canny
