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

}  // namespace

Hull::Hull(std::vector<Vec3> vertices)
    : vertices_(std::move(vertices)), radius_(greatest_length(vertices_) * (1 + 8 * u)) {}

Hull::Hull(const Vec3& point) : Hull(std::vector<Vec3>{point}) { first_spoke_ = {0, 0}; }

Hull Hull::of_vertices(const Polytope& polytope) { return Hull(polytope.vertices); }

Hull Hull::of_vertices(const Box& box) { return Hull(vertices_of(box)); }

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

void Hull::add_faces(const Loops& loops, const HalfEdges& edges) {
  faces_.resize(loops.count());
  for (std::size_t f = 0; f < loops.count(); ++f) {
    faces_[f].normal = polygon_normal(vertices_, loops[f]);
    faces_[f].first_corner = loops.first[f];
    faces_[f].corner_count = static_cast<int>(loops[f].size());
  }
  corners_ = loops.corners;
  radius_ = greatest_length(vertices_) * (1 + 8 * u);
  link_edges(edges);
  link_spokes();
  raise_faces();
}

void Hull::link_edges(const HalfEdges& edges) {
  sides_.resize(corners_.size());
  edges_.reserve(corners_.size() / 2);
  for (std::size_t i = 0; i < edges.sorted().size(); ++i) {
    const HalfEdge &there = edges.sorted()[i], &back = edges.twin(i);
    if (there.from > there.to) continue;
    Edge edge;
    edge.tail = there.from;
    edge.head = there.to;
    edge.face[0] = there.face;
    edge.face[1] = back.face;
    edge.along = vertex(edge.head) - vertex(edge.tail);
    edge.squared = edge.along.squaredNorm();
    edge.out[0] = edge.along.cross(face(there.face).normal);
    edge.out[1] = face(back.face).normal.cross(edge.along);
    sides_[at(there.place)] = sides_[at(back.place)] = edge_count();
    edges_.push_back(edge);
  }
}

void Hull::link_spokes() {
  first_spoke_.assign(vertices_.size() + 1, 0);
  for (const Edge& e : edges_) {
    ++first_spoke_[at(e.tail) + 1];
    ++first_spoke_[at(e.head) + 1];
  }
  for (std::size_t v = 1; v < first_spoke_.size(); ++v) first_spoke_[v] += first_spoke_[v - 1];
  spokes_.resize(at(first_spoke_.back()));
  std::vector<int> next(first_spoke_.begin(), first_spoke_.end() - 1);
  for (int e = 0; e < edge_count(); ++e) {
    const Edge& ends = edge(e);
    const double length = ends.along.stableNorm();
    shortest_edge_ = std::min(shortest_edge_, length);
    const Vec3 away = ends.along / length;
    spokes_[at(next[at(ends.tail)]++)] = {away, e, ends.head};
    spokes_[at(next[at(ends.head)]++)] = {-away, e, ends.tail};
  }
}

/// As in bracket.h: if each corner's neighbours outside the face are surely lower, a corner is the highest of all
/// vertices.
void Hull::raise_faces() {
  for (Face& f : faces_) {
    const auto height_of = [&](int v) { return f.normal.dot(vertex(v)); };
    const int* first = corners_.data() + f.first_corner;
    const int* last = first + f.corner_count;
    f.height = height_of(*first);
    bool sure = true;
    for (const int* c = first; c != last; ++c) {
      f.height = std::max(f.height, height_of(*c));
      for (const Spoke* s = spokes_begin(*c); s != spokes_end(*c); ++s) {
        const bool lower = f.normal.dot(s->away) < -10 * u;
        sure = sure && (lower || std::find(first, last, s->other) != last);
      }
    }
    for (int v = 0; !sure && v < vertex_count(); ++v) f.height = std::max(f.height, height_of(v));
  }
}

}  // namespace touchstone::fast::lin_canny
