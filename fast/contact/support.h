// The vertices and the face of a polytope that are outermost along a direction.
#pragma once

#include <vector>

#include "fast/lin_canny/posed_hull.h"

namespace touchstone::fast::contact {

/// The minimum of n·x over the vertices (m).
double lowest(const lin_canny::PosedHull& hull, const Vec3& n);

struct SupportingFace {
  int face = -1;       ///< −1: a point has no faces
  double cosine = -1;  ///< of the angle between its outward normal and the direction
};

/// The face whose outward normal is nearest to the unit vector `out`; the first of several.
SupportingFace supporting_face(const lin_canny::PosedHull& hull, const Vec3& out);

/// The outward unit normal of a face.
Vec3 face_normal(const lin_canny::PosedHull& hull, int face);

/// The corners of a face, counter-clockwise seen from outside.
std::vector<Vec3> face_corners(const lin_canny::PosedHull& hull, int face);

}  // namespace touchstone::fast::contact
