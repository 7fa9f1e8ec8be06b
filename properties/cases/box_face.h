// The face of a box that a point is above.
#pragma once

#include <optional>

#include "model/scene.h"
#include "oracle/truth/impact.h"

namespace touchstone::properties {

using Plane = Eigen::Matrix<oracle::Real, 2, 1>;

/// A face of a box: its middle, and a frame whose z is the outward normal.
struct Face {
  oracle::Point middle = oracle::Point::Zero();      ///< m
  oracle::Matrix R_WF = oracle::Matrix::Identity();  ///< columns: two edges, the normal
  Plane half = Plane::Zero();                        ///< m
  oracle::Point in_face(const oracle::Point& v) const { return R_WF.transpose() * v; }
};

/// The face above whose middle part the point lies; none if it is beside the box, or inside.
std::optional<Face> face_below(const Body& box, const oracle::Point& p);

}  // namespace touchstone::properties
