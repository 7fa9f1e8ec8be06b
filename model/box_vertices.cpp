#include "model/box_vertices.h"

namespace touchstone {

std::vector<Vec3> vertices_of(const Box& box) {
  std::vector<Vec3> vertices;
  vertices.reserve(8);
  for (int i = 0; i < 8; ++i) {
    const Vec3 signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    vertices.emplace_back(signs.cwiseProduct(box.half_extents));
  }
  return vertices;
}

Polytope as_polytope(const Box& box) {
  return {vertices_of(box), {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
}

}  // namespace touchstone
