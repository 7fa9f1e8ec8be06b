// Two convex parts where both stand exactly as their poses say: apart, overlapping, or in contact that approaches or
// parts.
//
// Cores swollen by r touch. x − y = d* for all closest points of the cores. Every plane between the two at the contact
// has its normal n (from B to A) in a cone: the ray of d* if r > 0; else that of facet normals
// (reference/touching_impl.h). With u the velocity of A at x against B at y, the distance grows at the rate of
//   the greatest over unit n of the least over (x, y) of n·u(x, y),
// a game in which both sides choose from convex sets: the two approach if one x is bad for every n, part if one n is
// good for every x. It is enough to look at the extreme rays, and at the extreme points of the contact, as u is linear.
#pragma once

#include <array>
#include <vector>

#include "model/scene.h"
#include "reference/flight_impl.h"

namespace touchstone::reference {

struct Standing {
  enum class Kind { apart, overlapping, approaching, parting, neither };
  Kind kind = Kind::apart;
  Triple n;                      ///< in contact: parting, one that is good for every x; else one of the cone
  Triple x, y;                   ///< in contact: closest points of the cores; approaching, those that do so along n
  std::vector<bool> on_A, on_B;  ///< parting: which vertices are on the planes n·p = n·x and n·p = n·y
};

/// `apart` is a part of r.
Standing standing(const Body& A, int part_A, const Departure& a, const Body& B, int part_B, const Departure& b,
                  double apart);

Triple velocity(const Departure& body, const Triple& at);  ///< of its point there, at its start

/// The extreme points x of {closest points of core A}, where d = x − y for the closest points y of core B.
std::vector<Triple> closest_points_on_A(const Body& A, int part_A, const Body& B, int part_B, const Triple& d);

}  // namespace touchstone::reference
