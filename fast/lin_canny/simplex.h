// Simplices of vertex differences b − a, in doubles, for Gilbert, Johnson & Keerthi's descent over B − A.
#pragma once

#include <array>

#include "fast/lin_canny/posed_hull.h"

namespace touchstone::fast::lin_canny {

struct VertexDifference {
  int a = 0;  ///< vertices of the two hulls
  int b = 0;
  Vec3 p_a;  ///< the vertex of A, in the pair's frame
  Vec3 w;    ///< b − a
};

/// Up to four differences, of which the first `size` count.
struct Simplex {
  explicit Simplex(const VertexDifference& first) : size(1) { points[0] = first; }

  const Vec3& w(int i) const { return points[static_cast<std::size_t>(i)].w; }
  void add(const VertexDifference& next) { points[static_cast<std::size_t>(size++)] = next; }

  std::array<VertexDifference, 4> points;
  std::array<double, 4> weights{};  ///< of the point nearest to 0; their sum is not 1
  int size = 0;
};

/// The difference lowest along n. Looks at all vertices.
VertexDifference lowest(const PosedHull& A, const PosedHull& B, const Vec3& n);

/// Leaves the least subset that contains the nearest point to 0 in its interior, as far as doubles can tell; false if
/// they find none. `toward`: a positive multiple of that point; 0 for four points.
bool reduce(Simplex& held, Vec3& toward);

/// A choice that ends a descent: where it makes progress, it takes a few steps more than a simplex has vertices.
inline constexpr int most_vertices = 40;

}  // namespace touchstone::fast::lin_canny
