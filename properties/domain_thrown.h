// Bodies that are thrown: small solids with velocities in small integers, for flights and for runs.
#pragma once

#include "model/scene.h"
#include "properties/random.h"

namespace touchstone::properties {

/// A ball, box, prism, pyramid or bipyramid, no point farther than 8 from its origin, at rest at the origin; turned by
/// any small quaternion once in two.
Body some_solid(Random& random);

/// m: no point of such a body is farther from its origin.
inline constexpr double solid_reach = 8;

Body some_ball(Random& random);
Body some_box(Random& random);

/// With density, or for one in four with given mass and moments: three different ones, two equal ones, or all equal.
Body with_mass(Random& random, Body body);

/// Spinning: mostly a body whose moments are all equal, by up to some turns; else by a fraction of one, since its true
/// flight then has no closed form, and costs.
Body spun(Random& random, Body body);

Body fixed(Body body);

Body at(Body body, const Vec3& p);
Body moving(Body body, const Vec3& v, const Vec3& w = Vec3::Zero());

/// Its own flight, from 0 to `end`, looked at `looks` times at equal steps. `end` is a small dyadic, `looks` a power of
/// two.
Flight flight_until(double end, int looks = 1);

/// Restitution and friction out of a few of each; never so little restitution that solids stay in contact and impacts
/// pile up.
Material some_material(Random& random);

/// One of the six directions of the axes.
Vec3 some_axis(Random& random);

/// The world turned by axes.
Scene turned_somehow(Random& random, Scene scene);

}  // namespace touchstone::properties
