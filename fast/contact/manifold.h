// Contact points of two convex parts: the features that touch where the parts are extreme along the normal.
#pragma once

#include <utility>
#include <vector>

#include "fast/contact/part.h"

namespace touchstone::fast::contact {

/// Two features that may press against each other.
struct ContactPoint {
  ContactPoint(Feature on_a, Feature on_b) : a(std::move(on_a)), b(std::move(on_b)) {}

  Feature a, b;
  Vec3 F_A_W = Vec3::Zero();  ///< N; the mean force on A in the last step
  double h = 0;               ///< s; the length of that step
};

/// The corners of the region in which each part is within `within` of the other's extreme plane perpendicular to n̂;
/// empty if the two outlines do not overlap. A corner is a point of one part over a plane of the other, or a crossing
/// of two edges, or the contact of a ball.
std::vector<ContactPoint> contact_points(const Part& A, const Part& B, const Vec3& nhat_BA_W, double within);

/// A contact point between the two given points of A and B, with normal n̂.
ContactPoint contact_point_between(const Part& A, const Vec3& p_Wa, const Part& B, const Vec3& p_Wb,
                                   const Vec3& nhat_BA_W);

}  // namespace touchstone::fast::contact
