#include "fast/lin_canny/boundary/merged_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "fast/exact/vector.h"
#include "fast/lin_canny/rotation.h"
#include "model/input_error.h"

namespace touchstone::fast::lin_canny {
namespace {

using Loop = std::vector<int>;

[[noreturn]] void refuse(const std::string& what) { throw InputError("shape.faces", what); }

/// > 0 if d is on the outer side of the plane through a, b, c (counter-clockwise from outside); exact sign.
///
/// In doubles the determinant of differences has an error of less than 16u times the product of the three lengths (each
/// difference u, each of six products of three 2u more, five sums); what that cannot decide is computed exactly.
int side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ad = d - a;
  const double volume = ad.dot(ab.cross(ac));
  const double error = 16 * u * ab.lpNorm<1>() * ac.lpNorm<1>() * ad.lpNorm<1>();
  if (std::abs(volume) > error + 0x1p-900 && std::isfinite(error)) return volume > 0 ? 1 : -1;
  using namespace exact;
  const Vector o = vector(a);
  return dot(vector(d) - o, cross(vector(b) - o, vector(c) - o)).sign();
}

/// Exact; the cross product's error is less than 8u|ab||ac|.
bool on_one_line(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  if (ab.cross(ac).lpNorm<1>() > 16 * u * ab.lpNorm<1>() * ac.lpNorm<1>() + 0x1p-900) return false;
  using namespace exact;
  const Vector o = vector(a);
  return cross(vector(b) - o, vector(c) - o).is_zero();
}

/// The polytope's loops, each from its least vertex on.
Loops loops_of(const std::vector<std::vector<int>>& faces) {
  Loops loops;
  loops.first.reserve(faces.size() + 1);
  loops.corners.reserve(3 * faces.size());
  for (const Loop& face : faces) {
    const std::size_t first = loops.corners.size();
    loops.add(face);
    const auto begin = loops.corners.begin() + static_cast<std::ptrdiff_t>(first);
    std::rotate(begin, std::min_element(begin, loops.corners.end()), loops.corners.end());
  }
  return loops;
}

class Merger {
 public:
  explicit Merger(const Polytope& polytope)
      : points_(polytope.vertices), loops_(loops_of(polytope.faces)), edges_(loops_, points_.size()) {
    if (loops_.count() < 4) refuse("expected the faces of a solid; derive them first");
    corners_.reserve(loops_.count());
    for (std::size_t f = 0; f < loops_.count(); ++f) corners_.push_back(three_corners(loops_[f]));
    root_.resize(loops_.count());
    std::iota(root_.begin(), root_.end(), 0);
  }

  MergedFaces merged() {
    const bool are_corners = each_is_corner();
    if (!unite_flat() && are_corners) {
      std::vector<int> all(points_.size());
      std::iota(all.begin(), all.end(), 0);
      return {std::move(all), std::move(loops_), std::move(edges_)};
    }
    std::vector<Loop> faces = united();
    drop_straight_corners(faces);
    return of_corners(faces);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const Vec3& point(int v) const { return points_[at(v)]; }

  int root(int f) const {
    while (root_[at(f)] != f) f = root_[at(f)];
    return f;
  }

  /// Whether each vertex is in three faces at least, so that none is straight or unused if no faces are united.
  bool each_is_corner() const {
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (edges_.degree(v) < 3) return false;
    }
    return true;
  }

  /// Unites coplanar neighbours; whether there are any.
  bool unite_flat() {
    bool any = false;
    const std::vector<HalfEdge>& edges = edges_.sorted();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const HalfEdge &edge = edges[i], &back = edges_.twin(i);
      if (edge.from > edge.to || !flat(edge, back)) continue;
      root_[at(root(edge.face))] = root(back.face);
      any = true;
    }
    return any;
  }

  std::vector<Loop> united() const {
    const std::vector<HalfEdge>& edges = edges_.sorted();
    std::vector<std::vector<HalfEdge>> rims(loops_.count());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const int face = root(edges[i].face);
      if (face != root(edges_.twin(i).face)) rims[at(face)].push_back(edges[i]);
    }
    std::vector<Loop> faces;
    for (const std::vector<HalfEdge>& rim : rims) {
      if (!rim.empty()) faces.push_back(chained(rim));
    }
    return faces;
  }

  /// Without the vertices that are corners of no face.
  MergedFaces of_corners(const std::vector<Loop>& faces) const {
    std::vector<int> index(points_.size(), -1), vertices;
    for (const Loop& face : faces) {
      for (const int v : face) index[at(v)] = 0;
    }
    for (std::size_t v = 0; v < index.size(); ++v) {
      if (index[v] < 0) continue;
      index[v] = static_cast<int>(vertices.size());
      vertices.push_back(static_cast<int>(v));
    }
    Loops loops;
    for (Loop face : faces) {
      for (int& v : face) v = index[at(v)];
      loops.add(face);
    }
    HalfEdges edges(loops, vertices.size());
    return {std::move(vertices), std::move(loops), std::move(edges)};
  }

  /// Whether the two faces at an edge are coplanar. Refuses faces that fold inward.
  bool flat(const HalfEdge& edge, const HalfEdge& back) const {
    const std::array<int, 3>& corner = corners_[at(edge.face)];
    const std::span<const int> other = loops_[at(back.face)];
    int fold = 0;
    for (const int v : other) {
      // In the plane by definition. Doubles could not tell, so it would be computed exactly, at great cost.
      if (std::ranges::find(corner, v) != corner.end()) continue;
      const int s = side(point(corner[0]), point(corner[1]), point(corner[2]), point(v));
      if (s > 0) refuse("not convex at edge " + std::to_string(edge.from) + "-" + std::to_string(edge.to));
      fold = std::min(fold, s);
    }
    return fold == 0;
  }

  /// Three corners of a polygon that are not collinear.
  std::array<int, 3> three_corners(std::span<const int> loop) const {
    for (std::size_t k = 2; k < loop.size(); ++k) {
      if (!on_one_line(point(loop[0]), point(loop[k - 1]), point(loop[k]))) return {loop[0], loop[k - 1], loop[k]};
    }
    refuse("a face without area");
  }

  /// Joins the sorted half-edges around a merged face into a loop.
  static Loop chained(const std::vector<HalfEdge>& rim) {
    Loop loop{rim.front().from};
    for (int v = rim.front().to; v != loop.front();) {
      const auto next = std::ranges::lower_bound(rim, v, {}, &HalfEdge::from);
      if (next == rim.end() || next->from != v || loop.size() >= rim.size()) refuse("a face with a hole");
      loop.push_back(v);
      v = next->to;
    }
    return loop;
  }

  /// A vertex in the middle of an edge belongs to two faces only.
  void drop_straight_corners(std::vector<Loop>& faces) const {
    std::vector<int> uses(points_.size());
    for (const Loop& face : faces) {
      for (const int v : face) ++uses[at(v)];
    }
    for (Loop& face : faces) std::erase_if(face, [&](int v) { return uses[at(v)] < 3; });
  }

  const std::vector<Vec3>& points_;
  Loops loops_;
  HalfEdges edges_;
  std::vector<std::array<int, 3>> corners_;  ///< of each face: three that are not collinear
  std::vector<int> root_;                    ///< by face: union-find parent; a root represents its merged face
};

}  // namespace

MergedFaces merged_faces(const Polytope& polytope) { return Merger(polytope).merged(); }

}  // namespace touchstone::fast::lin_canny
