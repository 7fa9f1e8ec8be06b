// The normal of two parts that touch so that many normals separate them: edge to edge, or at a corner.
#pragma once

#include <optional>

#include "fast/contact/part.h"

namespace touchstone::fast::simulation {

/// The normals of planes that separate two touching parts are a cone N. It has more than one direction where parallel
/// edges touch, or a corner touches a corner or an edge. `u` (m/s): the velocity of A relative to B at the contact.
///
/// Returns n̂ ∈ N with the fastest approach −n̂·u: the direction of the projection of −u onto N. The bodies came
/// together along it: a moment before, A was at −u δ from here, and n̂ was the direction of the shortest connection.
/// None if N has one direction (up to 2⁻²⁰), or if the bodies do not approach along one n̂ ∈ N (by more than 2⁻²⁰ |u|):
/// the plane perpendicular to that one separates them afterwards as well.
std::optional<Vec3> approach_normal(const contact::Part& A, const contact::Part& B, const Vec3& u);

}  // namespace touchstone::fast::simulation
