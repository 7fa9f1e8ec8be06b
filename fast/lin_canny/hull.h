// A convex solid prepared for the walk: its vertices, edges and faces, and their adjacency.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>

#include "fast/lin_canny/cube_map.h"
#include "model/shape.h"

namespace touchstone::fast::lin_canny {

/// The boundary of the hull of a polytope's vertices in the solid's own frame. Coplanar neighbouring faces are merged,
/// and vertices that are then no corners are dropped (decided exactly). So every edge has a Voronoi region of positive
/// width.
///
/// Laid out for caches, since of many pairs in turn each query finds its hulls in memory: one block, aligned to cache
/// lines, and no vector that two vertices and a normal give. It never changes, so copies share it. For n vertices of
/// degree 6 some 368 n bytes: 24 n of vertices, 132 n of spokes and 32 n of their edges, 48 n of edges, 80 n of faces,
/// 48 n of corners, 4 n of the table by direction.
class Hull {
 public:
  /// An edge runs from tail to head, counter-clockwise around face[0] and clockwise around face[1], both seen from
  /// outside. tail < head.
  struct Edge {
    int tail = 0;
    int head = 0;
    std::array<int, 2> face{};
  };
  /// Four edges as seen from one of their ends, in a cache line: unit vectors, rounded to floats, to the other ends. A
  /// vertex has as many as its edges need, with its last edge repeated.
  struct alignas(64) Spokes {
    static constexpr std::size_t lanes = 4;
    using Floats [[gnu::vector_size(16)]] = float;
    using Ints [[gnu::vector_size(16)]] = int;

    Floats x{};
    Floats y{};
    Floats z{};
    Ints other{};
  };
  /// A plane polygon.
  struct Face {
    Vec3 normal;        ///< outward, unit length within 4u
    double height = 0;  ///< greatest computed normal·v: the exact one of any vertex v is at most 4u·radius greater
    int first_corner = 0;
    int corner_count = 0;
  };
  /// Of a face, counter-clockwise seen from outside.
  struct Corner {
    int vertex = 0;
    int side = 0;  ///< the edge to the next corner
  };

  /// A single point: a sphere's core.
  explicit Hull(const Vec3& point);
  explicit Hull(const Box& box);
  /// Requires faces (reference::completed). Throws InputError if they are not the closed boundary of a convex solid.
  explicit Hull(const Polytope& polytope);
  /// The vertices alone, without edges and faces: for queries that are asked once. All of them are kept, also those
  /// that are no corners.
  static Hull of_vertices(std::span<const Vec3> vertices) { return Hull(vertices); }

  int vertex_count() const { return static_cast<int>(vertices_.size()); }
  int edge_count() const { return static_cast<int>(edges_.size()); }
  int face_count() const { return static_cast<int>(faces_.size()); }

  std::span<const Vec3> vertices() const { return vertices_; }
  const Vec3& vertex(int v) const { return vertices_[static_cast<std::size_t>(v)]; }
  const Edge& edge(int e) const { return edges_[static_cast<std::size_t>(e)]; }
  const Face& face(int f) const { return faces_[static_cast<std::size_t>(f)]; }
  std::span<const Corner> corners(const Face& face) const {
    return {corners_.data() + face.first_corner, static_cast<std::size_t>(face.corner_count)};
  }
  std::span<const Spokes> spokes(int v) const {
    const int* const first = first_spokes_.data() + v;
    return {spokes_.data() + first[0], static_cast<std::size_t>(first[1] - first[0])};
  }
  /// The edge of a lane of some of spokes(v).
  int edge_of(const Spokes& some, std::size_t lane) const {
    return spoke_edges_[static_cast<std::size_t>(&some - spokes_.data()) * Spokes::lanes + lane];
  }

  /// A vertex about as high along d as any, from a table; -1 of a hull that has none, since its vertices are few.
  /// Requires max |d_i| = 1.
  int by_direction(const Vec3& d) const { return by_direction_.empty() ? -1 : by_direction_[directions_.cell(d)]; }

  /// head − tail.
  Vec3 along(const Edge& edge) const { return vertex(edge.head) - vertex(edge.tail); }
  /// ≥ |v| for all vertices v.
  double radius() const { return radius_; }
  /// Whether products of four lengths neither overflow nor lose bits to underflow, as the walk and its bracket need.
  bool fits_doubles() const { return radius_ < 0x1p250 && shortest_edge_ > 0x1p-250; }

 private:
  struct Boundary;

  /// Of vertices alone.
  explicit Hull(std::span<const Vec3> vertices);
  explicit Hull(const Boundary& boundary);

  std::span<const Vec3> vertices_;
  std::span<const int> first_spokes_;  ///< by vertex, with one more at the end
  std::span<const Spokes> spokes_;
  double radius_ = 0;
  double shortest_edge_ = 1;  ///< at most 1
  std::span<const Edge> edges_;
  std::span<const Face> faces_;
  std::span<const Corner> corners_;
  std::span<const int> spoke_edges_;  ///< by lane
  CubeMap directions_;
  std::span<const int> by_direction_;         ///< by cell: a vertex
  std::shared_ptr<const std::byte[]> block_;  ///< of all arrays
};

/// A direction d in the hull's frame, rounded to floats, for a first look at the slopes of edges: what floats decide
/// needs no doubles.
///
/// With v = 2^-24: |slope − a·d| ≤ error() for the exact unit vector a along the edge. Σ|a_i d_i| ≤ |d| ≤ |d|₁. A
/// component of a, computed within 5u, rounds to a float by v of itself; so does one of d; the three products and two
/// sums round by at most 3v of Σ|a_i d_i|: 5v|d|₁ in all, and terms of second order. Two more v|d|₁ cover these, the
/// 5u, what a double's a·d rounds by (3.1u), and the rounding of the bound itself. Floats below 2^-126 err by 2^-150
/// each, which is less than 2^-89 of |d|₁ > 2^-60. If |d|₁ is not between 2^-60 and 2^60 the error is infinite, and
/// nothing is decided.
class FloatDirection {
 public:
  using Slopes = Hull::Spokes::Floats;

  explicit FloatDirection(const Vec3& d) {
    const double size = d.lpNorm<1>();
    if (!(size > 0x1p-60 && size < 0x1p60)) return;
    x_ = static_cast<float>(d.x());
    y_ = static_cast<float>(d.y());
    z_ = static_cast<float>(d.z());
    error_ = static_cast<float>(7 * 0x1p-24 * size);
  }

  float error() const { return error_; }
  Slopes slopes(const Hull::Spokes& some) const { return some.x * x_ + some.y * y_ + some.z * z_; }

  /// Whether all edges at a vertex surely lead down, except the one to `except`.
  bool lead_down(std::span<const Hull::Spokes> spokes, int except = -1) const {
    Hull::Spokes::Ints may_rise{};
    for (const Hull::Spokes& some : spokes) may_rise |= ~(slopes(some) < -error_) & (some.other != except);
    return (may_rise[0] | may_rise[1] | may_rise[2] | may_rise[3]) == 0;
  }

 private:
  float x_ = 0;
  float y_ = 0;
  float z_ = 0;
  float error_ = std::numeric_limits<float>::infinity();
};

}  // namespace touchstone::fast::lin_canny
