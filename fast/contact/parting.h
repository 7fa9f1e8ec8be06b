// How far two convex parts are apart along a normal, and the normal that separates them.
#pragma once

#include <vector>

#include "fast/contact/part.h"
#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::contact {

/// The separation of the two parts along n̂ (m); < 0: overlap.
double apart(const Part& A, const Part& B, const Vec3& nhat_BA_W);

/// The separation along n̂ of each vertex of A from B, then of each vertex of B from A (m). `apart` is the minimum of
/// these.
std::vector<double> clearances(const Part& A, const Part& B, const Vec3& nhat_BA_W);

/// From B to A: the normal of B's face nearest to n̂, and the negated normal of A's face nearest to −n̂, each only if
/// within 25° of n̂.
std::vector<Vec3> faces_along(const Part& A, const Part& B, const Vec3& nhat_BA_W);

/// The direction of the shortest connection of the two parts. If they touch, the normal of greatest separation among
/// those of faces and of pairs of edges. A face's normal within 2⁻²⁰ of it replaces it if it separates the parts as
/// well.
Vec3 parting(const Part& A, const Part& B, const lin_canny::Proximity& near);

/// The same of parts whose closest points are not known yet, at the poses of their bodies. Of two balls the centres
/// tell.
Vec3 parting(const Part& A, const lin_canny::CachedPose& X_WA, const Part& B, const lin_canny::CachedPose& X_WB);

}  // namespace touchstone::fast::contact
