// What the comparisons with FCL share.
#pragma once

#include <fcl/geometry/shape/convex.h>

#include <memory>
#include <vector>

#include "model/scene.h"

namespace touchstone::bench {

inline std::shared_ptr<fcl::Convexd> fcl_convex(const Polytope& polytope) {
  const auto faces = std::make_shared<std::vector<int>>();
  for (const std::vector<int>& face : polytope.faces) {
    faces->push_back(static_cast<int>(face.size()));
    faces->insert(faces->end(), face.begin(), face.end());
  }
  return std::make_shared<fcl::Convexd>(std::make_shared<const std::vector<Vec3>>(polytope.vertices),
                                        static_cast<int>(polytope.faces.size()), faces);
}

}  // namespace touchstone::bench
