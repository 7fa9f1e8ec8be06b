// A polytope inside B − A that grows vertex by vertex: the inner bound of van den Bergen's expanding polytope.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fast/lin_canny/simplex.h"
#include "fast/penetration/triangulation.h"

namespace touchstone::fast::penetration {

/// A closed surface of triangles whose corners are differences b − a of vertices. It is convex within rounding when it
/// is grown at one pose; at the next pose the same triangles start the search, and need not be convex.
class InnerPolytope {
 public:
  struct Plane {
    Vec3 n = Vec3::Zero();  ///< outward, unit length within 4u
    double height = 0;      ///< n · corner
    bool is_final = false;  ///< no vertex of B − A is farther along n, as far as doubles can tell
  };

  bool empty() const { return surface_.empty(); }
  int corner_count() const { return static_cast<int>(corners_.size()); }
  const Plane& plane(int face) const { return planes_[static_cast<std::size_t>(face)]; }
  void set_final(int face) { planes_[static_cast<std::size_t>(face)].is_final = true; }
  /// The face with the least height that is not final.
  std::optional<int> nearest_face() const;

  void clear();
  /// Four differences that are not in one plane. The two hulls must outlive the next change of the polytope.
  void start(const lin_canny::PosedHull& A, const lin_canny::PosedHull& B,
             const std::array<lin_canny::VertexDifference, 4>& corners);
  /// The same triangles at another pose. No face with a plane is final then.
  void move(const lin_canny::PosedHull& A, const lin_canny::PosedHull& B);
  /// Replaces the faces from which w is visible, those in whose plane it is within `margin` included, by a cone from w.
  /// `from`: a face from which it is visible. Returns the least height of the new faces; none, and nothing has changed,
  /// if the outline of the old ones is not one cycle.
  std::optional<double> insert(const lin_canny::VertexDifference& w, int from, double margin);

  /// Whether 0 is inside, given that it is on no face: the determinants of all faces are positive beyond their
  /// rounding, or else the sum of the solid angles is a multiple of 4π above 0.
  bool encloses_origin() const;
  /// The least n · x over the corners x of all faces, each with its own n.
  double least_height() const;

 private:
  const Vec3& corner(int i) const { return corners_[static_cast<std::size_t>(i)].w; }
  Vec3 edge(int tail, int head) const;
  void set_plane(int face);

  const lin_canny::PosedHull* A_ = nullptr;
  const lin_canny::PosedHull* B_ = nullptr;
  std::vector<lin_canny::VertexDifference> corners_;
  Triangulation surface_;
  std::vector<Plane> planes_;  ///< by triangle
};

}  // namespace touchstone::fast::penetration
