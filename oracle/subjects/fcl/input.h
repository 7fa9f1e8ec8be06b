// Converts scenes to FCL's types.
#pragma once

#include <fcl/fcl.h>

#include <memory>
#include <vector>

#include "oracle/subjects/common/engine.h"

namespace touchstone::oracle::subjects::in_fcl {

using Geometry = std::shared_ptr<::fcl::CollisionGeometryd>;

struct MakeGeometry {
  Geometry operator()(const Sphere& sphere) const { return std::make_shared<::fcl::Sphered>(sphere.radius); }
  /// FCL's box takes full side lengths.
  Geometry operator()(const Box& box) const { return std::make_shared<::fcl::Boxd>(Vec3(2 * box.half_extents)); }
  Geometry operator()(const Polytope& polytope) const {
    const auto faces = std::make_shared<std::vector<int>>();
    for (const std::vector<int>& face : polytope.faces) {
      faces->push_back(static_cast<int>(face.size()));
      faces->insert(faces->end(), face.begin(), face.end());
    }
    return std::make_shared<::fcl::Convexd>(std::make_shared<const std::vector<Vec3>>(polytope.vertices),
                                            static_cast<int>(polytope.faces.size()), faces);
  }
  Geometry operator()(const Compound&) const { return nullptr; }
};

inline ::fcl::Transform3d transform(const Pose& X_WB) {
  ::fcl::Transform3d X = ::fcl::Transform3d::Identity();
  X.linear() = rotation(X_WB.q_WB).toRotationMatrix();
  X.translation() = X_WB.p_WB;
  return X;
}

struct FclBody {
  explicit FclBody(const Body& body) : geometry(std::visit(MakeGeometry{}, body.shape)), X_WB(transform(body.X_WB)) {}
  Geometry geometry;
  ::fcl::Transform3d X_WB;
};

}  // namespace touchstone::oracle::subjects::in_fcl
