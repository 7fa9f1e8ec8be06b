// Where two convex parts stand on each other: the features that touch, and the direction that keeps the two apart.
#pragma once

#include <utility>
#include <vector>

#include "fast/contact/feature.h"
#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::contact {

/// A convex part of a body that stands somewhere. The part must outlive it.
struct Part {
  const lin_canny::Convex* convex = nullptr;
  lin_canny::Placed core;  ///< in W
  Stance body;

  bool is_ball() const { return convex->core.vertex_count() == 1; }
};

Part part_of(const lin_canny::Convex& convex, const lin_canny::Station& station, const Stance& body);

/// Two features that may push each other apart.
struct Foot {
  Foot(Feature on_a, Feature on_b) : a(std::move(on_a)), b(std::move(on_b)) {}

  Feature a, b;
  Vec3 P_A_W = Vec3::Zero();  ///< N s; of the last step
};

/// The corners of the region in which the two are within `within` of each other's outermost planes across n̂; none where
/// these outlines have nothing in common. A corner is a point of the one over a plane of the other; or two edges that
/// cross, or what a ball touches.
std::vector<Foot> feet(const Part& A, const Part& B, const Vec3& nhat_BA_W, double within);

/// How far n̂ keeps each vertex of A from B, and each of B from A (m).
std::vector<double> clearances(const Part& A, const Part& B, const Vec3& nhat_BA_W);

/// The least of these.
double apart(const Part& A, const Part& B, const Vec3& nhat_BA_W);

/// The two given points of A and B, kept apart along n̂.
Foot foot_between(const Part& A, const Vec3& p_Wa, const Part& B, const Vec3& p_Wb, const Vec3& nhat_BA_W);

/// Normals of the face of B that n̂ is nearest to, and of A's that −n̂ is, where they are within 25° of it: from B to A.
std::vector<Vec3> faces_along(const Part& A, const Part& B, const Vec3& nhat_BA_W);

/// The direction of the shortest way between the two; of two that touch, that of a face, or across an edge of each,
/// that keeps them apart best. In its place a face's normal that is within 2⁻²⁰ of it, if that keeps them apart as
/// well.
Vec3 parting(const Part& A, const Part& B, const lin_canny::Proximity& near);

}  // namespace touchstone::fast::contact
