// Decides exactly on which side of a plane a point lies.
#pragma once

#include "model/frame.h"

namespace touchstone::oracle {

/// The sign of (b − a) × (c − a) · (d − a), for any finite doubles: 1 if a, b, c are counter-clockwise seen from d's
/// side of their plane, 0 if all four points lie in one plane.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Do the points lie exactly on one straight line?
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace touchstone::oracle
