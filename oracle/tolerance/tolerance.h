// How wrong a correct computation in the subject's precision may be: named bounds in SI units, derived in
// oracle/tolerance/tolerance.cpp.
//
// They bound the effect of rounding on a backward stable computation without overflow or underflow. They are not tuned:
// an engine that stops at a tolerance of its own exceeds them, and its grade (oracle/judge/grade.h) says by how much.
#pragma once

#include "model/scene.h"
#include "oracle/subject.h"

namespace touchstone::oracle::tolerance {

/// Greatest distance of a point of the body from the body's origin, m.
double radius(const Body& body);

/// Greatest distance of a point from the first vertex of a convex body, or from the centre of a sphere or box, m; for a
/// compound its radius. The scale of its inertia, as it does not grow if a shape is away from its origin.
double size(const Body& body);

/// S = max over bodies of (|p_WB|∞ + radius), m.
double scale(const Scene& scene);

/// u·S, m: the unit of the errors in findings.
double ulp(const Scene& scene, Precision precision);

/// m: |computed − exact| of the distance of two bodies, and how near to touching a verdict may be wrong.
double distance(const Scene& scene, Precision precision);

/// m: distance of a computed witness point from its body.
double witness(const Scene& scene, Precision precision);

/// m: |computed − exact| of the penetration depth.
double penetration(const Scene& scene, Precision precision);

/// m: common depth that may remain after the stated translation.
double separation(const Scene& scene, Precision precision);

/// 1: ||n| − 1| of a computed unit vector.
double unit_length(Precision precision);

/// Whether n has the length 1, but for the rounding of a unit vector.
bool is_unit(const Vec3& n, Precision precision);

/// m: how much wider a conservative tight box may be than the exact one, on each side.
double bounds(const Scene& scene, Precision precision);

/// m: how far outside a projection, or a depth, a conservative pixel test may still report. Requires a raster.
double pixel(const Scene& scene, Precision precision);

/// Pixels: how many more pixels on each side a conservative test may mark than the exact one: one, and those within
/// `pixel`. More than `most_pixels_around` are not counted.
inline constexpr int most_pixels_around = 1 << 24;
int pixels_around(const Scene& scene, Precision precision);

/// Error bounds of one body's mass (kg), centre of mass (m) and moments and products of inertia (kg m²), if they follow
/// from the shape. 0 for given properties, and for an exact subject, whose answer is in the truth's enclosure.
struct MassBound {
  double mass = 0;
  double centre = 0;
  double inertia = 0;
};
MassBound mass(const Body& body, Precision precision);

/// The same of given properties that an engine keeps in its own form and returns: 1/m, the moments' inverses and the
/// principal axes.
MassBound mass_as_kept(const MassProperties& given, Precision precision);

/// m: the same of the place of a body at rest, of which an engine may keep another point.
double place_as_kept(const Body& body, Precision precision);

/// m/s: the same of the velocity of a fixed body's fastest point. An engine may keep it in the body's axes; a stepper
/// may compute it from two poses.
double velocity_as_kept(const Body& body, Precision precision, const std::optional<Stepping>& stepping);

}  // namespace touchstone::oracle::tolerance
