// Contact points of two convex parts: the features that touch, and the normal that separates the parts.
#pragma once

#include <utility>
#include <vector>

#include "fast/contact/feature.h"
#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::contact {

/// A convex part of a body at a pose. Refers to the part, which must outlive it.
struct Part {
  const lin_canny::Convex* convex = nullptr;
  lin_canny::PosedHull core;  ///< in W
  RigidTransform body;

  bool is_ball() const { return convex->core.vertex_count() == 1; }
};

Part part_of(const lin_canny::Convex& convex, const lin_canny::CachedPose& cached_pose, const RigidTransform& body);

/// Two features that may press against each other.
struct ContactPoint {
  ContactPoint(Feature on_a, Feature on_b) : a(std::move(on_a)), b(std::move(on_b)) {}

  Feature a, b;
  Vec3 P_A_W = Vec3::Zero();  ///< N s; of the last step
};

/// The corners of the region in which each part is within `within` of the other's extreme plane perpendicular to n̂;
/// empty if the two outlines do not overlap. A corner is a point of one part over a plane of the other, or a crossing
/// of two edges, or the contact of a ball.
std::vector<ContactPoint> contact_points(const Part& A, const Part& B, const Vec3& nhat_BA_W, double within);

/// The separation along n̂ of each vertex of A from B, then of each vertex of B from A (m).
std::vector<double> clearances(const Part& A, const Part& B, const Vec3& nhat_BA_W);

/// The minimum of these.
double apart(const Part& A, const Part& B, const Vec3& nhat_BA_W);

/// A contact point between the two given points of A and B, with normal n̂.
ContactPoint contact_point_between(const Part& A, const Vec3& p_Wa, const Part& B, const Vec3& p_Wb,
                                   const Vec3& nhat_BA_W);

/// From B to A: the normal of B's face nearest to n̂, and the negated normal of A's face nearest to −n̂, each only if
/// within 25° of n̂.
std::vector<Vec3> faces_along(const Part& A, const Part& B, const Vec3& nhat_BA_W);

/// The direction of the shortest connection of the two parts. If they touch, the normal of greatest separation among
/// those of faces and of pairs of edges. A face's normal within 2⁻²⁰ of it replaces it if it separates the parts as
/// well.
Vec3 parting(const Part& A, const Part& B, const lin_canny::Proximity& near);

}  // namespace touchstone::fast::contact
