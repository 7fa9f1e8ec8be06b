// The orientation of a ball after a rotation.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::simulation {

/// The rotation of q followed by that by the vector `angle` (rad; along the axis, in W). Its norm is 1 within 8u.
///
/// q' = (cos h, sin h · angle/|angle|) q/|q|, h = |angle|/2, computed by + − × ÷ and sqrt alone. Error: (4 + |angle|) u
/// rad, as much as rounding the angle itself causes. Beyond 2⁵⁰ rad doubles cannot resolve the angle, and q is
/// returned, normalized by a power of two only.
Quaternion turned(const Quaternion& q, const Vec3& angle);

/// Whether the axis of the angular velocity w + alpha t turns: |w × alpha| > 8u |w| |alpha|. If not, alpha differs from
/// a vector along w by some roundings of its own.
bool axis_turns(const Vec3& w, const Vec3& alpha);

/// The rotation of q followed by `tau` s with the angular velocity w + alpha t (in W). Its norm is 1 within 8u.
///
/// If the axis stays, this is `turned` by the angle ∫ ω dt. Otherwise rotations about the axes do not commute, and that
/// angle is wrong: by up to |w × alpha| tau³/12. q' = ½ (w + alpha t) q has a power series that converges for all t. It
/// is summed up to the 18th power in N = `turning_steps` equal steps, each of which rotates by at most a radian.
///
/// Error: at most 33u N rad. Over a step of length h the coefficients of q are at most those of exp(y s + z s²), with
/// y = h|ω|/2 ≤ 1/2 and z = h²|alpha|/4 ≤ 1/64, and s = 1 at its end. By Cauchy's estimate for |s| = 16 the terms that
/// are left out sum to less than 16/15 · exp(16 y + 256 z) 16⁻¹⁹ < 2⁻⁵⁸. Rounding: the first term has 7u y by h and ω,
/// and 8u y by the product with q; all others together have less; the sum has u. That is 16u as a quaternion, 32u rad.
/// Beyond 2¹⁶ steps q is returned, normalized by a power of two only: a run stops before (World::keep_orientation).
Quaternion turned(const Quaternion& q, const Vec3& w, const Vec3& alpha, double tau);

/// N = 1 + ⌊max(|w|, |w + alpha tau|, 4√|alpha|) tau⌋: at least as many as the radians that the body turns.
double turning_steps(const Vec3& w, const Vec3& alpha, double tau);

}  // namespace touchstone::fast::simulation
