// A convex solid ready for the walk: its vertices, edges and faces, and who is whose neighbour.
#pragma once

#include <vector>

#include "model/shape.h"

namespace touchstone::fast::lin_canny {

/// Boundary of the hull of a polytope's vertices in the solid's own frame. Coplanar neighbouring faces are one face,
/// and what is then no corner is no vertex (decided exactly): so every edge has a region of positive width around it.
class Hull {
 public:
  /// An edge as seen from one of its ends.
  struct Spoke {
    Vec3 away;  ///< unit vector from this end to the other: off by less than 5u
    int edge = 0;
    int other = 0;  ///< the other end
  };
  /// From tail to head, counter-clockwise round face[0] and clockwise round face[1], both seen from outside.
  struct Edge {
    int tail = 0;
    int head = 0;
    int face[2] = {0, 0};
    Vec3 along;          ///< head − tail
    double squared = 0;  ///< along·along
    Vec3 out[2];  ///< in the plane of face[i], at right angles to the edge, away from the face; not of unit length
  };
  /// A plane polygon. `corners[first_corner + i]` to the next one is edge `edges[first_corner + i]`, counter-clockwise.
  struct Face {
    Vec3 normal;        ///< outward, unit length within 4u
    double height = 0;  ///< greatest computed normal·v: of the exact ones, none of any vertex v is greater by 4u·radius
    int first_corner = 0;
    int corner_count = 0;
  };

  /// A single point: a sphere's core.
  explicit Hull(const Vec3& point);
  explicit Hull(const Box& box);
  /// Requires faces (reference::completed). Throws InputError where they are not the closed boundary of a convex solid.
  explicit Hull(const Polytope& polytope);

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
  /// Index of a vertex in the polytope or box that this was made from.
  int source(int v) const { return source_[static_cast<std::size_t>(v)]; }
  /// ≥ |v| for all vertices v.
  double radius() const { return radius_; }
  /// Products of four lengths neither overflow nor lose bits to underflow: the walk and its bracket need that.
  bool fits_doubles() const { return radius_ < 0x1p250 && shortest_edge_ > 0x1p-250; }

 private:
  void add_faces(const std::vector<std::vector<int>>& loops);
  void link_edges();
  void link_spokes();
  void raise_faces();

  std::vector<Vec3> vertices_;
  std::vector<int> source_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<Spoke> spokes_;
  std::vector<int> first_spoke_;  ///< by vertex, and one more
  std::vector<int> corners_;
  std::vector<int> sides_;
  double radius_ = 0;
  double shortest_edge_ = 1;  ///< or 1
};

}  // namespace touchstone::fast::lin_canny
