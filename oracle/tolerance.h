// How wrong a correct computation in the subject's precision may be: named bounds, in SI units, derived in
// tolerance.cpp.
//
// They bound what rounding does to a backward stable computation without overflow or underflow. They are not tuned: an
// engine that stops at a tolerance of its own is outside them, and its grade (oracle/grade.h) says by how much.
#pragma once

#include "model/scene.h"
#include "oracle/subject.h"

namespace touchstone::oracle::tolerance {

/// Greatest distance of a point of the body from the body's own origin, m.
double radius(const Body& body);

/// Greatest distance of a point of a convex body from its first vertex, of a sphere or box from its centre, m; of a
/// compound its radius. What its inertia is measured by: it does not grow when a shape is off its origin.
double size(const Body& body);

/// S = max over bodies of (|p_WB|∞ + radius), m.
double scale(const Scene& scene);

/// u·S, m: the unit that findings count in.
double ulp(const Scene& scene, Precision precision);

/// m: |computed − exact| of the distance of two bodies, and how near to touching a verdict may be wrong.
double distance(const Scene& scene, Precision precision);

/// m: how far a computed witness point may be from its body.
double witness(const Scene& scene, Precision precision);

/// m: |computed − exact| of the penetration depth.
double penetration(const Scene& scene, Precision precision);

/// m: common depth that may be left after the stated translation.
double separation(const Scene& scene, Precision precision);

/// 1: ||n| − 1| of a computed unit vector.
double unit_length(Precision precision);

/// m: how much wider, a side, a conservative tight box may be than the exact one.
double bounds(const Scene& scene, Precision precision);

/// m: how far from a picture, or from a depth, a conservative test at pixels may be. Requires a raster.
double pixel(const Scene& scene, Precision precision);

/// Pixels: how much further on each side a conservative test may mark than the exact one: one, and what `pixel` makes up.
int pixels_around(const Scene& scene, Precision precision);

/// Of one body's mass (kg), centre of mass (m) and moments and products of inertia (kg m²). 0 for an exact subject,
/// whose answer lies in the truth's enclosure, and for given properties, which are repeated.
struct MassBound {
  double mass = 0;
  double centre = 0;
  double inertia = 0;
};
MassBound mass(const Body& body, Precision precision);

}  // namespace touchstone::oracle::tolerance
