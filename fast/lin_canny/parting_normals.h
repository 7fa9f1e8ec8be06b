// Directions among which there is one that separates two convex bodies, if any does (separating axis theorem).
#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "fast/lin_canny/posed_hull.h"
#include "model/infinity.h"

namespace touchstone::fast::lin_canny {

/// Whether `found` returns true for one of the normals, from B to A, of planes along a face of B, a face of A, or an
/// edge of each. Calls it in a fixed order, and stops at the first true. Edges within 2⁻²⁰ of parallel define no
/// direction.
template <class Found>
bool any_parting_normal(const PosedHull& A, const PosedHull& B, Found&& found) {
  for (int f = 0; f < A.hull->face_count(); ++f) {
    if (found(Vec3(-A.turned_out(A.hull->face(f).normal)))) return true;
  }
  for (int f = 0; f < B.hull->face_count(); ++f) {
    if (found(B.turned_out(B.hull->face(f).normal))) return true;
  }
  std::vector<std::pair<Vec3, double>> edges_of_B;  // turned and measured once, not once for each edge of A
  for (int j = 0; j < B.hull->edge_count(); ++j) {
    const Vec3 e = B.edge_vector(j);
    edges_of_B.emplace_back(e, e.norm());
  }
  for (int i = 0; i < A.hull->edge_count(); ++i) {
    const Vec3 d = A.edge_vector(i);
    const double least = 0x1p-20 * d.norm();
    for (const auto& [e, length] : edges_of_B) {
      const Vec3 n = d.cross(e);
      const double size = n.norm();
      if (!(size > least * length)) continue;
      if (found(Vec3(n / size)) || found(Vec3(-n / size))) return true;
    }
  }
  return false;
}

/// Among these normals the one with the greatest `width`; the first of several.
template <class Width>
Vec3 widest_parting_normal(const PosedHull& A, const PosedHull& B, Width&& width) {
  Vec3 best = Vec3::UnitZ();
  double widest = -infinity;
  any_parting_normal(A, B, [&](const Vec3& n) {
    const double wide = width(n);
    if (wide > widest) widest = wide, best = n;
    return false;
  });
  return best;
}

}  // namespace touchstone::fast::lin_canny
