// Bodies in motion: small solids with velocities in small integers, for the families of time_of_impact and simulation.
#pragma once

#include "model/scene.h"
#include "properties/random.h"

namespace touchstone::properties {

/// A ball, box, prism, pyramid or bipyramid at rest at the origin, with all points within 8 of its origin; rotated by a
/// small quaternion with probability 1/2.
Body some_solid(Random& random);

/// m: all points of such a body are within this distance of its origin.
inline constexpr double solid_reach = 8;

Body some_ball(Random& random);
Body some_box(Random& random);

/// With a density; or, with probability 1/4, with given mass and moments: three different, two equal, or all equal.
Body with_mass(Random& random, Body body);

/// Adds spin. Usually the body gets equal moments and rotates up to several times; otherwise it rotates by a fraction
/// of a turn, since the exact motion of a tumbling body is expensive.
Body spun(Random& random, Body body);

/// Three different moments or two equal ones (kg m²), for a mass of some kg and a radius of 1 m.
Mat3 unlike_moments(Random& random);

Body fixed(Body body);

/// Fixed, 512 m wide, its top at z = 0.
Body large_table(const Material& material);

Body at(Body body, const Vec3& p);
Body moving(Body body, const Vec3& v, const Vec3& w = Vec3::Zero());

/// A motion from 0 to `end` with `samples` samples at equal steps. `end` is a small dyadic, `samples` a power of two.
Motion motion_until(double end, int samples = 1);

/// Restitution and friction, each out of a few values. Restitution is never so low that solids stay in contact and
/// impacts accumulate.
Material some_material(Random& random);

/// The scene under a random rotation that maps axes to axes.
Scene turned_somehow(Random& random, Scene scene);

/// Two bodies in motion, in random order and under such a rotation.
Scene thrown(Random& random, Body A, Body B, Motion motion, const Vec3& gravity = Vec3::Zero());

}  // namespace touchstone::properties
