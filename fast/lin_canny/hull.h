// A convex solid prepared for the walk: its vertices, edges and faces, and their adjacency.
#pragma once

#include <utility>
#include <vector>

#include "model/shape.h"

namespace touchstone::fast::lin_canny {

class HalfEdges;
struct Loops;

/// The boundary of the hull of a polytope's vertices in the solid's own frame. Coplanar neighbouring faces are merged,
/// and vertices that are then no corners are dropped (decided exactly). So every edge has a Voronoi region of positive
/// width.
class Hull {
 public:
  /// An edge as seen from one of its ends.
  struct Spoke {
    Vec3 away;  ///< unit vector from this end to the other, with an error of less than 5u
    int edge = 0;
    int other = 0;  ///< the other end
  };
  /// From tail to head, counter-clockwise around face[0] and clockwise around face[1], both seen from outside.
  struct Edge {
    int tail = 0;
    int head = 0;
    int face[2] = {0, 0};
    Vec3 along;          ///< head − tail
    double squared = 0;  ///< along·along
    Vec3 out[2];         ///< in the plane of face[i], perpendicular to the edge, away from the face; not of unit length
  };
  /// A plane polygon. The edge from `corners[first_corner + i]` to the next is `edges[first_corner + i]`,
  /// counter-clockwise.
  struct Face {
    Vec3 normal;        ///< outward, unit length within 4u
    double height = 0;  ///< greatest computed normal·v: the exact one of any vertex v is at most 4u·radius greater
    int first_corner = 0;
    int corner_count = 0;
  };

  /// A single point: a sphere's core.
  explicit Hull(const Vec3& point);
  explicit Hull(const Box& box);
  /// Requires faces (reference::completed). Throws InputError if they are not the closed boundary of a convex solid.
  explicit Hull(const Polytope& polytope);
  /// The vertices alone, without edges and faces: for queries that are asked once. All of them are kept, also those
  /// that are no corners.
  static Hull of_vertices(std::vector<Vec3> vertices) { return Hull(std::move(vertices)); }

  int vertex_count() const { return static_cast<int>(vertices_.size()); }
  int edge_count() const { return static_cast<int>(edges_.size()); }
  int face_count() const { return static_cast<int>(faces_.size()); }

  const Vec3& vertex(int v) const { return vertices_[static_cast<std::size_t>(v)]; }
  const Edge& edge(int e) const { return edges_[static_cast<std::size_t>(e)]; }
  const Face& face(int f) const { return faces_[static_cast<std::size_t>(f)]; }
  const Spoke* spokes_begin(int v) const { return spokes_.data() + first_spoke_[static_cast<std::size_t>(v)]; }
  const Spoke* spokes_end(int v) const { return spokes_begin(v + 1); }
  int corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }
  int side(int i) const { return sides_[static_cast<std::size_t>(i)]; }

  const std::vector<Vec3>& vertices() const { return vertices_; }
  /// Index of a vertex in the polytope or box that this hull was made from.
  int source(int v) const { return source_.empty() ? v : source_[static_cast<std::size_t>(v)]; }
  /// ≥ |v| for all vertices v.
  double radius() const { return radius_; }
  /// Whether products of four lengths neither overflow nor lose bits to underflow, as the walk and its bracket need.
  bool fits_doubles() const { return radius_ < 0x1p250 && shortest_edge_ > 0x1p-250; }

 private:
  /// Of vertices alone.
  explicit Hull(std::vector<Vec3> vertices);
  void add_faces(const Loops& loops, const HalfEdges& half_edges);

  std::vector<Vec3> vertices_;
  std::vector<int> source_;  ///< empty: each vertex has kept its index
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<Spoke> spokes_;
  std::vector<int> first_spoke_;  ///< by vertex, with one more at the end
  std::vector<int> corners_;
  std::vector<int> sides_;
  double radius_ = 0;
  double shortest_edge_ = 1;  ///< at most 1
};

}  // namespace touchstone::fast::lin_canny
