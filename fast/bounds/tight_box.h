// The tight box of a moving body; its polytopes' extremal vertices are remembered from frame to frame.
#pragma once

#include <vector>

#include "fast/bounds/climb.h"
#include "model/scene.h"

namespace touchstone::fast {

/// As fast/bounds.h at every pose, and within the same bound E; but a polytope costs only the vertices that are climbed
/// past. Spheres and boxes have closed forms and remember nothing.
class TightBox {
 public:
  /// Requires a valid shape. Throws InputError if a polytope's faces are missing or are not the boundary of a convex
  /// solid.
  explicit TightBox(const Shape& shape);

  Aabb at(const Pose& X_WB);

  /// Whether any part has vertices to climb.
  bool climbs() const { return !climbs_.empty(); }

 private:
  Shape shape_;
  std::vector<Climb> climbs_;  ///< one per polytope, in the order of parts
};

}  // namespace touchstone::fast
