#include "fast/lin_canny/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fast/lin_canny/half_edges.h"
#include "fast/lin_canny/merged_faces.h"
#include "fast/lin_canny/rotation.h"

namespace touchstone::fast::lin_canny {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double greatest_length(const std::vector<Vec3>& vertices) {
  double greatest = 0;
  for (const Vec3& v : vertices) greatest = std::max(greatest, v.stableNorm());
  return greatest;
}

Vec3 unit(const Vec3& v) { return v.stableNormalized(); }

/// The sum over the fan's triangles from the first corner; corners are scaled by the polygon's size, so that nothing
/// overflows or underflows.
Vec3 polygon_normal(const std::vector<Vec3>& corners) {
  double size = 0;
  for (const Vec3& c : corners) size = std::max(size, (c - corners[0]).lpNorm<Eigen::Infinity>());
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k) {
    sum += ((corners[k - 1] - corners[0]) / size).cross((corners[k] - corners[0]) / size);
  }
  return unit(sum);
}

/// Vertex i is at (±hx, ±hy, ±hz) by the bits of i (model/shape.h).
std::vector<Vec3> corners_of(const Box& box) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    const Vec3 signs{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0};
    corners.push_back(signs.cwiseProduct(box.half_extents));
  }
  return corners;
}

}  // namespace

Hull::Hull(const Vec3& point) : vertices_{point}, source_{0}, first_spoke_{0, 0}, radius_(greatest_length(vertices_)) {
  radius_ *= 1 + 8 * u;
}

Hull::Hull(const Box& box) : vertices_(corners_of(box)), source_{0, 1, 2, 3, 4, 5, 6, 7} {
  add_faces({{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

Hull::Hull(const Polytope& polytope) {
  std::vector<std::vector<int>> loops = merged_faces(polytope);
  std::vector<int> index(polytope.vertices.size(), -1);
  for (const auto& loop : loops) {
    for (const int v : loop) index[at(v)] = 0;
  }
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] < 0) continue;
    index[v] = vertex_count();
    vertices_.push_back(polytope.vertices[v]);
    source_.push_back(static_cast<int>(v));
  }
  for (auto& loop : loops) {
    for (int& v : loop) v = index[at(v)];
  }
  add_faces(loops);
}

void Hull::add_faces(const std::vector<std::vector<int>>& loops) {
  for (const std::vector<int>& loop : loops) {
    std::vector<Vec3> corners;
    for (const int v : loop) corners.push_back(vertex(v));
    Face face;
    face.normal = polygon_normal(corners);
    face.first_corner = static_cast<int>(corners_.size());
    face.corner_count = static_cast<int>(loop.size());
    corners_.insert(corners_.end(), loop.begin(), loop.end());
    faces_.push_back(face);
  }
  radius_ = greatest_length(vertices_) * (1 + 8 * u);
  link_edges(loops);
  link_spokes();
  raise_faces();
}

void Hull::link_edges(const std::vector<std::vector<int>>& loops) {
  const HalfEdges edges(loops, vertices_.size());
  sides_.resize(corners_.size());
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
