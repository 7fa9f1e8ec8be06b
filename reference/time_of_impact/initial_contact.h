// The state of two convex parts at exactly the poses of the scene: apart, overlapping, or in contact that approaches or
// separates.
//
// Consider cores that touch when swollen by r. x − y = d* for all closest points of the cores. Every plane that
// separates the two at the contact has its normal n (from B to A) in a cone: the ray of d* if r > 0; else the cone of
// facet normals (reference/distance/touching_only.h). With u the velocity of A at x relative to B at y, the distance
// grows at the rate
//   max over unit n of min over (x, y) of n·u(x, y).
// This is a minimax over convex sets. The two approach if one x has n·u < 0 for every n; they separate if one n has n·u
// > 0 for every x. It is enough to test the extreme rays and the extreme points of the contact, as u is linear.
#pragma once

#include <array>
#include <vector>

#include "model/scene.h"
#include "reference/motion/ballistic_motion.h"

namespace touchstone::reference {

struct InitialContact {
  enum class Kind { apart, overlapping, approaching, separating, neither };
  Kind kind = Kind::apart;
  Triple n;                     ///< in contact: if separating, an n that is so for every x; else one of the cone
  std::vector<Triple> normals;  ///< in contact: the extreme rays of the cone of normals, and perhaps some more
  Triple x, y;  ///< in contact: closest points of the cores; if approaching, those that approach along n
  std::vector<bool> on_A, on_B;  ///< separating: the vertices on the planes n·p = n·x and n·p = n·y
};

/// `apart` is added to r.
InitialContact initial_contact(const Body& A, int part_A, const BallisticStart& a, const Body& B, int part_B,
                               const BallisticStart& b, double apart);

Triple velocity(const BallisticStart& body, const Triple& at);  ///< of the body's point `at`, at its start

std::vector<Triple> vertices_at_start(const Body& body, int part);  ///< of the core, in W

/// The extreme points of the set of closest points x of core A, where d = x − y for the closest points y of core B.
std::vector<Triple> closest_points_on_A(const Body& A, int part_A, const Body& B, int part_B, const Triple& d);

}  // namespace touchstone::reference
