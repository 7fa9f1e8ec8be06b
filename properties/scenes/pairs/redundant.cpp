// Polytopes with vertices that are not corners of their hull: in the middle of edges and faces, in any order.
#include <algorithm>
#include <set>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

int add(Polytope& solid, const Vec3& p) {
  solid.vertices.push_back(p);
  return static_cast<int>(solid.vertices.size()) - 1;
}

const Vec3& vertex(const Polytope& solid, int i) { return solid.vertices[static_cast<std::size_t>(i)]; }

/// Inserts the vertex between i and j of the face, if it has that edge.
void split(std::vector<int>& face, int i, int j, int vertex) {
  for (std::size_t k = 0; k < face.size(); ++k) {
    const std::size_t next = (k + 1) % face.size();
    if (face[k] != i || face[next] != j) continue;
    face.insert(face.begin() + static_cast<std::ptrdiff_t>(k) + 1, vertex);
    return;
  }
}

/// Adds the middle of an edge, which the faces name or do not.
void add_on_edge(Random& random, Polytope& solid, int i, int j) {
  const int middle = add(solid, (vertex(solid, i) + vertex(solid, j)) / 2);
  if (random.one_in(2)) return;
  for (std::vector<int>& face : solid.faces) {
    split(face, i, j, middle);
    split(face, j, i, middle);
  }
}

/// The same solid with its vertices in another order.
Polytope shuffled(Random& random, const Polytope& solid) {
  const std::size_t count = solid.vertices.size();
  std::vector<std::size_t> place(count);
  for (std::size_t i = 0; i < count; ++i) place[i] = i;
  for (std::size_t i = count; i > 1; --i) {
    std::swap(place[i - 1], place[random.index(i)]);
  }
  Polytope other;
  other.vertices.resize(count);
  for (std::size_t i = 0; i < count; ++i) other.vertices[place[i]] = solid.vertices[i];
  for (std::vector<int> face : solid.faces) {
    for (int& i : face) i = static_cast<int>(place[static_cast<std::size_t>(i)]);
    other.faces.push_back(std::move(face));
  }
  return other;
}

Scene redundant(Random& random) {
  Polytope below = with_redundant_vertices(random, summit(random, some_kind(random)));
  Polytope above = depression(random, some_kind(random));
  if (random.one_in(2)) above = with_redundant_vertices(random, std::move(above));
  const Vec3 shift{random.whole(-2, 2), random.whole(-2, 2), 0};
  const double gap = dyadic_gap(random, 1, 18);
  const Pose X{Vec3::Zero(), small_quaternion(random)};
  return across(random, std::move(below), shifted(std::move(above), shift), gap, X);
}

}  // namespace

Polytope with_redundant_vertices(Random& random, Polytope solid) {
  const std::vector<std::vector<int>> faces = solid.faces;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::vector<int>& face = faces[f];
    if (f == 0 || random.one_in(2)) {  // within the triangle of three corners
      add(solid, (vertex(solid, face[0]) + vertex(solid, face[1]) + 2 * vertex(solid, face[2])) / 4);
    }
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int i = face[k], j = face[(k + 1) % face.size()];
      if (i < j && random.one_in(2)) add_on_edge(random, solid, i, j);
    }
  }
  return shuffled(random, solid);
}

std::vector<Family> redundant_families() {
  return {{"hulls.redundant", "vertices on edges and in faces, in any order, touching or nearly", convex_pair_queries,
           true, redundant}};
}

}  // namespace touchstone::properties
