#include "app/report/wire_part.h"

#include <algorithm>
#include <type_traits>
#include <variant>

namespace touchstone::app {
namespace {

using Edges = std::set<std::pair<int, int>>;

Edges edges_of(const Sphere&) { return {}; }

Edges edges_of(const Box&) {
  Edges edges;
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) {
      if ((i & bit) == 0) edges.emplace(i, i | bit);
    }
  }
  return edges;
}

Edges edges_of(const Polytope& polytope) {
  Edges edges;
  for (const std::vector<int>& face : polytope.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) edges.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
  }
  return edges;
}

double radius_of(const ConvexShape& shape) {
  const auto* sphere = std::get_if<Sphere>(&shape);
  return sphere != nullptr ? sphere->radius : 0;
}

std::vector<ConvexShape> parts_of(const Shape& shape) {
  std::vector<ConvexShape> parts;
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    for (const Part& part : compound->parts) parts.push_back(part.shape);
  } else {
    std::visit(
        [&](const auto& convex) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(convex)>, Compound>) parts.emplace_back(convex);
        },
        shape);
  }
  return parts;
}

}  // namespace

std::vector<WirePart> wire_parts(const Scene& scene) {
  std::vector<WirePart> all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::vector<ConvexShape> parts = parts_of(scene.bodies[b].shape);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      all.push_back({static_cast<int>(b), oracle::world_points(scene.bodies[b], static_cast<int>(p)),
                     std::visit([](const auto& shape) { return edges_of(shape); }, parts[p]), radius_of(parts[p])});
    }
  }
  return all;
}

}  // namespace touchstone::app
