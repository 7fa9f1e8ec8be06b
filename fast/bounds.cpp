#include "fast/bounds.h"

#include <variant>

#include "fast/outward/outward.h"

namespace touchstone::fast {

Aabb box(const Body& body) {
  outward::Grower grower;
  std::visit([&](const auto& shape) { grow(grower, shape, outward::motion(body.X_WB)); }, body.shape);
  return grower.box();
}

Bounds bounds(const Scene& scene) {
  Bounds boxes;
  boxes.reserve(scene.bodies.size());
  for (const Body& body : scene.bodies) boxes.push_back(box(body));
  return boxes;
}

}  // namespace touchstone::fast
