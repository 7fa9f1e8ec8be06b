#include "fast/lin_canny/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "fast/lin_canny/merged_faces.h"
#include "fast/lin_canny/rotation.h"
#include "model/box_vertices.h"

namespace touchstone::fast::lin_canny {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A plain square, if it neither over- nor underflows, errs by less than 4u of itself and a stable norm by less than
/// 8u. So the vertex with the greatest stable norm is among those whose squares are within 64u of the greatest.
double greatest_length(const std::vector<Vec3>& vertices) {
  double square = 0;
  for (const Vec3& v : vertices) square = std::max(square, v.squaredNorm());
  const double enough = square > 0x1p-900 && square < 0x1p900 ? square * (1 - 64 * u) : 0;
  double greatest = 0;
  for (const Vec3& v : vertices) {
    if (!(v.squaredNorm() < enough)) greatest = std::max(greatest, v.stableNorm());
  }
  return greatest;
}

Vec3 unit(const Vec3& v) { return v.stableNormalized(); }

/// The sum over the fan's triangles from the first corner; corners are scaled by the polygon's size, so that nothing
/// overflows or underflows.
Vec3 polygon_normal(const std::vector<Vec3>& vertices, std::span<const int> loop) {
  const auto corner = [&](std::size_t i) -> const Vec3& { return vertices[at(loop[i])]; };
  double size = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    size = std::max(size, (corner(i) - corner(0)).lpNorm<Eigen::Infinity>());
  }
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < loop.size(); ++k) {
    sum += ((corner(k - 1) - corner(0)) / size).cross((corner(k) - corner(0)) / size);
  }
  return unit(sum);
}

/// Requires the hull's vertices and faces.
Hull::Edge edge_between(const Hull& hull, const HalfEdge& there, const HalfEdge& back) {
  Hull::Edge edge;
  edge.tail = there.from;
  edge.head = there.to;
  edge.face[0] = there.face;
  edge.face[1] = back.face;
  edge.along = hull.vertex(edge.head) - hull.vertex(edge.tail);
  edge.squared = edge.along.squaredNorm();
  edge.out[0] = edge.along.cross(hull.face(there.face).normal);
  edge.out[1] = hull.face(back.face).normal.cross(edge.along);
  return edge;
}

/// The edges as seen from their ends, by vertex.
struct Spokes {
  std::vector<int> first;  ///< by vertex, with one more at the end
  std::vector<Hull::Spoke> list;
  double shortest = 1;  ///< at most 1
};

Spokes spokes_of(const Hull& hull) {
  Spokes spokes;
  spokes.first.assign(hull.vertices().size() + 1, 0);
  for (int e = 0; e < hull.edge_count(); ++e) {
    ++spokes.first[at(hull.edge(e).tail) + 1];
    ++spokes.first[at(hull.edge(e).head) + 1];
  }
  for (std::size_t v = 1; v < spokes.first.size(); ++v) spokes.first[v] += spokes.first[v - 1];
  spokes.list.resize(at(spokes.first.back()));
  std::vector<int> next(spokes.first.begin(), spokes.first.end() - 1);
  for (int e = 0; e < hull.edge_count(); ++e) {
    const Hull::Edge& edge = hull.edge(e);
    const double length = edge.along.stableNorm();
    spokes.shortest = std::min(spokes.shortest, length);
    const Vec3 away = edge.along / length;
    spokes.list[at(next[at(edge.tail)]++)] = {away, e, edge.head};
    spokes.list[at(next[at(edge.head)]++)] = {-away, e, edge.tail};
  }
  return spokes;
}

/// The greatest height of a vertex above the origin along the face's normal. As in bracket.h: if each corner's
/// neighbours outside the face are surely lower, a corner is the highest of all vertices.
double greatest_height(const Hull& hull, const Hull::Face& face) {
  const auto height_of = [&](int v) { return face.normal.dot(hull.vertex(v)); };
  const auto is_corner = [&](int v) {
    for (int i = 0; i < face.corner_count; ++i) {
      if (hull.corner(face.first_corner + i) == v) return true;
    }
    return false;
  };
  double height = height_of(hull.corner(face.first_corner));
  bool sure = true;
  for (int i = 0; i < face.corner_count; ++i) {
    const int corner = hull.corner(face.first_corner + i);
    height = std::max(height, height_of(corner));
    for (const Hull::Spoke* s = hull.spokes_begin(corner); s != hull.spokes_end(corner); ++s) {
      const bool lower = face.normal.dot(s->away) < -10 * u;
      sure = sure && (lower || is_corner(s->other));
    }
  }
  for (int v = 0; !sure && v < hull.vertex_count(); ++v) height = std::max(height, height_of(v));
  return height;
}

}  // namespace

Hull::Hull(std::vector<Vec3> vertices)
    : vertices_(std::move(vertices)), radius_(greatest_length(vertices_) * (1 + 8 * u)) {}

Hull::Hull(const Vec3& point) : Hull(std::vector<Vec3>{point}) { first_spoke_ = {0, 0}; }

Hull::Hull(const Box& box) : vertices_(vertices_of(box)) {
  static const std::vector<std::vector<int>> faces = as_polytope(box).faces;  // the same for every box
  Loops loops;
  for (const auto& face : faces) loops.add(face);
  add_faces(loops, HalfEdges(loops, vertices_.size()));
}

Hull::Hull(const Polytope& polytope) {
  MergedFaces faces = merged_faces(polytope);
  vertices_.reserve(faces.vertices.size());
  for (const int v : faces.vertices) vertices_.push_back(polytope.vertices[at(v)]);
  source_ = std::move(faces.vertices);
  add_faces(faces.loops, faces.edges);
}

void Hull::add_faces(const Loops& loops, const HalfEdges& half_edges) {
  faces_.resize(loops.count());
  for (std::size_t f = 0; f < loops.count(); ++f) {
    faces_[f].normal = polygon_normal(vertices_, loops[f]);
    faces_[f].first_corner = loops.first[f];
    faces_[f].corner_count = static_cast<int>(loops[f].size());
  }
  corners_ = loops.corners;
  radius_ = greatest_length(vertices_) * (1 + 8 * u);
  sides_.resize(corners_.size());
  edges_.reserve(corners_.size() / 2);
  for (std::size_t i = 0; i < half_edges.sorted().size(); ++i) {
    const HalfEdge &there = half_edges.sorted()[i], &back = half_edges.twin(i);
    if (there.from > there.to) continue;
    sides_[at(there.place)] = sides_[at(back.place)] = edge_count();
    edges_.push_back(edge_between(*this, there, back));
  }
  Spokes spokes = spokes_of(*this);
  first_spoke_ = std::move(spokes.first);
  spokes_ = std::move(spokes.list);
  shortest_edge_ = spokes.shortest;
  for (Face& face : faces_) face.height = greatest_height(*this, face);
}

}  // namespace touchstone::fast::lin_canny
