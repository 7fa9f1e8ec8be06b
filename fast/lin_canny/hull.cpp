#include "fast/lin_canny/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "fast/lin_canny/boundary/merged_faces.h"
#include "fast/lin_canny/facing.h"
#include "fast/rounding.h"
#include "model/box_vertices.h"

namespace touchstone::fast::lin_canny {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A plain square, if it neither over- nor underflows, errs by less than 4u of itself and a stable norm by less than
/// 8u. So the vertex with the greatest stable norm is among those whose squares are within 64u of the greatest.
double greatest_length(std::span<const Vec3> vertices) {
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
Vec3 polygon_normal(std::span<const Vec3> vertices, std::span<const int> loop) {
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

std::vector<Hull::Face> faces_of(std::span<const Vec3> vertices, const Loops& loops) {
  std::vector<Hull::Face> faces(loops.count());
  for (std::size_t f = 0; f < loops.count(); ++f) {
    faces[f].normal = polygon_normal(vertices, loops[f]);
    faces[f].first_corner = loops.first[f];
    faces[f].corner_count = static_cast<int>(loops[f].size());
  }
  return faces;
}

struct EdgesAndCorners {
  std::vector<Hull::Edge> edges;
  std::vector<Hull::Corner> corners;
};

EdgesAndCorners edges_and_corners(const Loops& loops, const HalfEdges& half_edges) {
  EdgesAndCorners sides;
  sides.edges.reserve(loops.corners.size() / 2);
  sides.corners.resize(loops.corners.size());
  for (std::size_t i = 0; i < half_edges.sorted().size(); ++i) {
    const HalfEdge &there = half_edges.sorted()[i], &back = half_edges.twin(i);
    if (there.from > there.to) continue;
    const int edge = static_cast<int>(sides.edges.size());
    sides.corners[at(there.place)] = {there.from, edge};
    sides.corners[at(back.place)] = {back.from, edge};
    sides.edges.push_back({there.from, there.to, {there.face, back.face}});
  }
  return sides;
}

/// The edges as seen from their ends, by vertex.
struct AllSpokes {
  std::vector<int> first{0};  ///< by vertex, with one more at the end
  std::vector<Hull::Spokes> list;
  std::vector<int> edges;  ///< by lane
  double shortest = 1;     ///< length of an edge; at most 1
};

AllSpokes spokes_of(std::span<const Vec3> vertices, std::span<const Hull::Edge> edges) {
  constexpr int lanes = Hull::Spokes::lanes;
  std::vector<int> degrees(vertices.size());
  for (const Hull::Edge& edge : edges) ++degrees[at(edge.tail)], ++degrees[at(edge.head)];
  AllSpokes spokes;
  spokes.first.reserve(vertices.size() + 1);
  for (const int degree : degrees) spokes.first.push_back(spokes.first.back() + (degree + lanes - 1) / lanes);
  spokes.list.resize(at(spokes.first.back()));
  spokes.edges.resize(spokes.list.size() * lanes);
  const auto set = [&](int v, int place, const Vec3& away, int other, int edge) {
    Hull::Spokes& some = spokes.list[at(spokes.first[at(v)] + place / lanes)];
    const std::size_t lane = at(place % lanes);
    some.x[lane] = static_cast<float>(away.x());
    some.y[lane] = static_cast<float>(away.y());
    some.z[lane] = static_cast<float>(away.z());
    some.other[lane] = other;
    spokes.edges[at(spokes.first[at(v)] * lanes + place)] = edge;
  };
  std::vector<int> places(vertices.size());
  const auto add = [&](int v, const Vec3& away, int other, int edge) {
    int& place = places[at(v)];
    const int end = place + 1 < degrees[at(v)] ? place + 1 : (spokes.first[at(v) + 1] - spokes.first[at(v)]) * lanes;
    while (place < end) set(v, place++, away, other, edge);
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [tail, head, faces] = edges[e];
    const Vec3 along = vertices[at(head)] - vertices[at(tail)];
    const double length = along.stableNorm();
    spokes.shortest = std::min(spokes.shortest, length);
    const Vec3 away = along / length;
    add(tail, away, head, static_cast<int>(e));
    add(head, -away, tail, static_cast<int>(e));
  }
  return spokes;
}

/// The greatest height of a vertex above the origin along the face's normal. As in bracket.h: if each corner's
/// neighbours outside the face are surely lower, a corner is the highest of all vertices.
double greatest_height(const Hull& hull, const Hull::Face& face) {
  const auto height_of = [&](int v) { return face.normal.dot(hull.vertex(v)); };
  const auto is_corner = [&](int v) {
    return std::ranges::any_of(hull.corners(face), [&](const Hull::Corner& corner) { return corner.vertex == v; });
  };
  const FloatDirection n(face.normal);
  double height = height_of(hull.corners(face)[0].vertex);
  bool sure = true;
  for (const Hull::Corner& corner : hull.corners(face)) {
    height = std::max(height, height_of(corner.vertex));
    for (const Hull::Spokes& some : hull.spokes(corner.vertex)) {
      const FloatDirection::Slopes slopes = n.slopes(some);
      for (std::size_t lane = 0; lane < Hull::Spokes::lanes; ++lane) {
        sure = sure && (slopes[lane] < -n.error() || is_corner(some.other[lane]));
      }
    }
  }
  return sure ? height : std::max(height, greatest_height(hull, face.normal));
}

/// Of so many vertices there is no table: they are compared one by one in less time than a climb takes; at 20 in half
/// of it, at 50 in as much.
constexpr int few = 32;

constexpr std::size_t cache_line = alignof(Hull::Spokes);

/// Copies what the spans refer to into one allocation, each at the start of a cache line, and makes them refer to the
/// copies. The block keeps these alive; their destructors must do nothing.
template <class... Ts>
std::shared_ptr<const std::byte[]> packed(std::span<const Ts>&... arrays) {
  static_assert((std::is_trivially_destructible_v<Ts> && ...));
  const auto rounded = [](std::size_t bytes) { return (bytes + cache_line - 1) / cache_line * cache_line; };
  const std::size_t size = (std::size_t{0} + ... + rounded(arrays.size_bytes()));
  const auto block = std::make_shared_for_overwrite<std::byte[]>(size + cache_line - 1);
  std::byte* next =
      block.get() + (cache_line - reinterpret_cast<std::uintptr_t>(block.get()) % cache_line) % cache_line;
  const auto copied = [&]<class T>(std::span<const T> array) {
    T* const here = reinterpret_cast<T*>(next);
    std::uninitialized_copy(array.begin(), array.end(), here);
    next += rounded(array.size_bytes());
    return std::span<const T>(here, array.size());
  };
  ((arrays = copied(arrays)), ...);
  return block;
}

}  // namespace

struct Hull::Boundary {
  std::vector<Vec3> vertices;
  Loops loops;
  HalfEdges half_edges;

  static Boundary of(const Box& box) {
    static const Loops loops = [] {  // the same for every box
      Loops all;
      for (const auto& face : as_polytope(Box{}).faces) all.add(face);
      return all;
    }();
    static const HalfEdges half_edges(loops, 8);
    return {vertices_of(box), loops, half_edges};
  }
  static Boundary of(const Polytope& polytope) {
    MergedFaces faces = merged_faces(polytope);
    std::vector<Vec3> vertices;
    vertices.reserve(faces.vertices.size());
    for (const int v : faces.vertices) vertices.push_back(polytope.vertices[at(v)]);
    return {std::move(vertices), std::move(faces.loops), std::move(faces.edges)};
  }
};

Hull::Hull(std::span<const Vec3> vertices) : vertices_(vertices), radius_(greatest_length(vertices) * (1 + 8 * u)) {
  block_ = packed(vertices_);
}

Hull::Hull(const Vec3& point) : Hull(std::span(&point, 1)) {
  static constexpr std::array<int, 2> no_spokes{0, 0};
  first_spokes_ = no_spokes;
}

Hull::Hull(const Box& box) : Hull(Boundary::of(box)) {}
Hull::Hull(const Polytope& polytope) : Hull(Boundary::of(polytope)) {}

Hull::Hull(const Boundary& boundary) : vertices_(boundary.vertices), radius_(greatest_length(vertices_) * (1 + 8 * u)) {
  std::vector<Face> faces = faces_of(vertices_, boundary.loops);
  const EdgesAndCorners sides = edges_and_corners(boundary.loops, boundary.half_edges);
  const AllSpokes spokes = spokes_of(vertices_, sides.edges);
  edges_ = sides.edges;
  faces_ = faces;
  corners_ = sides.corners;
  spokes_ = spokes.list;
  first_spokes_ = spokes.first;
  spoke_edges_ = spokes.edges;
  shortest_edge_ = spokes.shortest;
  for (Face& face : faces) face.height = greatest_height(*this, face);
  std::vector<int> by_direction;
  if (vertex_count() > few) {
    // About as many cells as vertices: then a climb from a cell's vertex takes a step or none.
    directions_ = CubeMap(static_cast<int>(std::lround(std::sqrt(static_cast<double>(vertex_count()) / 6))));
    const std::size_t row = directions_.row_length();
    for (std::size_t cell = 0; cell < directions_.cell_count(); ++cell) {
      by_direction.push_back(climbed(*this, cell < row ? 0 : by_direction[cell - row], directions_.direction(cell)));
    }
  }
  by_direction_ = by_direction;
  block_ = packed(vertices_, first_spokes_, spokes_, edges_, faces_, corners_, spoke_edges_, by_direction_);
}

}  // namespace touchstone::fast::lin_canny
